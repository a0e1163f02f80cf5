#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <vector>

namespace rubsweep::batch {

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
