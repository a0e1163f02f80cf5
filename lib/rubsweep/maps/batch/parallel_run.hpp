#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace rubsweep::batch {

/// Number of threads for a request of `threads`: 0 is one per processor this process may use. Throws
/// ConfigError when threads < 0.
int thread_count(int threads);

/// Memory of this machine, in bytes.
std::size_t machine_memory_bytes();

/// Throws ConfigError when the system does not let this process run cells on as many threads as that, and
/// have `beside` more for itself: tested beforehand, because the threads that run the cells later could only
/// abort. One thread is always there, that of the caller, and nothing else is then tested.
void require_threads(int threads, int beside = 0);

/// Runs run_cell(0) ... run_cell(count - 1) on thread_count(threads) threads and returns how many finished.
/// Cells may differ in cost without bound: each is a task of its own. A cell must write to its own slot only;
/// then results do not depend on the number of threads.
///
/// `on_finished(cell)` follows each cell that did not throw, on the same thread, one call at a time, in any
/// order. What it throws ends the run: no new cell starts and the exception is rethrown as it is.
///
/// Once `stop` is true no new cell starts; cells already running finish and are counted.
///
/// When cells throw, the others still run; then the failure with the lowest cell index is thrown again with
/// "cell I: ... (N of COUNT cells failed)" as its message. ConfigError, IoError and SolverError keep their
/// type, any other std::exception becomes a SolverError. Throws ConfigError when threads < 0.
std::size_t parallel_run(std::size_t count, int threads,
                         const std::function<void(std::size_t cell)>& run_cell,
                         const std::function<void(std::size_t cell)>& on_finished,
                         const std::atomic<bool>& stop);

}  // namespace rubsweep::batch
