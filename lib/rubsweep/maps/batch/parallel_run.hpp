#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace rubsweep::batch {

/// Number of threads to use if `threads` are asked for; 0 means one per processor that this process may use.
/// Throws ConfigError where threads < 0.
int thread_count(int threads);

/// Memory of this machine, in bytes.
std::size_t machine_memory_bytes();

/// Throws ConfigError where the system cannot start `threads` threads for cells and `beside` more. This is
/// tested before a run, since a failure during the run could only abort the program. For one thread nothing
/// is tested, because the calling thread always exists.
void require_threads(int threads, int beside = 0);

/// Runs run_cell(0) ... run_cell(count - 1) on thread_count(threads) threads and returns how many finished.
/// Each cell is a separate task, since costs of cells differ without limit. A cell must write only to its own
/// slot; then results do not depend on the number of threads.
///
/// `on_finished(cell)` is called after each cell that did not throw, on the same thread, one call at a time,
/// in any order. An exception in it ends the run: no new cell starts, and the exception is rethrown
/// unchanged.
///
/// Once `stop` is true no new cell starts; cells already running finish and are counted.
///
/// If cells throw, the others still run. Then the exception of the cell with the lowest index is thrown again
/// with the message "cell I: ... (N of COUNT cells failed)". ConfigError, IoError and SolverError keep their
/// type, any other std::exception becomes a SolverError. Throws ConfigError where threads < 0.
std::size_t parallel_run(std::size_t count, int threads,
                         const std::function<void(std::size_t cell)>& run_cell,
                         const std::function<void(std::size_t cell)>& on_finished,
                         const std::atomic<bool>& stop);

/// Cells that a worker computes before it requests more.
using Chunk = std::vector<std::size_t>;

/// Gives cells in chunks to workers on any thread. The size of a chunk is chosen to take about `chunk_time`,
/// estimated from the worker's last chunk, so that the cost of a request is small. The cells of a chunk come
/// from all over the list. Chunks are then similar to each other, and the first results represent the whole
/// map. Chunks become smaller near the end, so that no worker has a large one while others are idle.
class ChunkQueue {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t first_chunk = 16, largest_chunk = 16384;
  static constexpr std::chrono::duration<double> chunk_time{0.25};

  /// `workers`: number of workers, which are numbered from 0.
  ChunkQueue(std::vector<std::size_t> cells, std::size_t workers);

  /// Next cells for a worker that has finished its last chunk; empty when no cells are left.
  Chunk next(std::size_t worker, Clock::time_point now = Clock::now());

  /// Adds a list of cells that follow when all present cells were given out.
  void refill(std::vector<std::size_t> cells);

  /// Gives no further cells of the present list to workers.
  void close();

 private:
  struct Last {
    std::size_t cells = 0;  ///< cells of the chunk; 0: no chunk yet
    Clock::time_point begun;
  };

  std::mutex mutex_;
  std::vector<std::size_t> cells_;
  /// Distance in the list, modulo its length, between cells given out one after another. It is coprime to the
  /// length, so that every cell is given out once.
  std::size_t stride_;
  std::size_t dealt_ = 0;
  std::vector<Last> last_;  ///< latest chunk of each worker
};

}  // namespace rubsweep::batch
