#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

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

/// Cells that one worker computes before it asks again.
using Chunk = std::vector<std::size_t>;

/// Deals out cells in chunks, to workers on any thread. A chunk is to take its worker about `chunk_time`, by
/// what its last one took, so that asking costs little whatever a cell costs. Its cells come from all over
/// the list, so that chunks are alike where neighbours are, and so that what is finished first speaks for
/// all. Towards the end chunks shrink, so that no worker is left with a large one while the others have
/// nothing to do.
class ChunkQueue {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t first_chunk = 16, largest_chunk = 16384;
  static constexpr std::chrono::duration<double> chunk_time{0.25};

  /// Workers count from 0.
  ChunkQueue(std::vector<std::size_t> cells, std::size_t workers);

  /// The next cells for a worker that has finished its last chunk; empty when all are dealt out.
  Chunk next(std::size_t worker, Clock::time_point now = Clock::now());

  /// Deals out these next, when the others are dealt out.
  void refill(std::vector<std::size_t> cells);

  /// Nothing more is dealt out of those there are.
  void close();

 private:
  struct Last {
    std::size_t cells = 0;  ///< 0: none yet
    Clock::time_point begun;
  };

  std::mutex mutex_;
  std::vector<std::size_t> cells_;
  std::size_t stride_;  ///< distance from a cell to the one dealt out next; every cell is met once
  std::size_t dealt_ = 0;
  std::vector<Last> last_;  ///< chunk of each worker
};

}  // namespace rubsweep::batch
