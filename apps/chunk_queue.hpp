#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace rubsweep::apps {

/// Cells that one rank computes before it asks again.
using Chunk = std::vector<std::size_t>;

/// Deals out cells in chunks, to any thread. Chunks shrink towards the end, so that no rank is left with a
/// large one while the others have nothing to do: a fixed share of what remains, between 1 and
/// `largest_chunk` cells.
class ChunkQueue {
 public:
  static constexpr std::size_t largest_chunk = 256;

  ChunkQueue(std::vector<std::size_t> cells, std::size_t ranks) : cells_(std::move(cells)), ranks_(ranks) {}

  /// The next cells; empty when all are dealt out.
  Chunk next() {
    const std::lock_guard lock(mutex_);
    const std::size_t left = cells_.size() - dealt_;
    const std::size_t size = std::min(left, std::clamp<std::size_t>(left / (4 * ranks_), 1, largest_chunk));
    const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(dealt_);
    dealt_ += size;
    return {begin, begin + static_cast<std::ptrdiff_t>(size)};
  }

  /// Nothing more is dealt out.
  void close() {
    const std::lock_guard lock(mutex_);
    dealt_ = cells_.size();
  }

 private:
  std::mutex mutex_;
  std::vector<std::size_t> cells_;
  std::size_t ranks_;
  std::size_t dealt_ = 0;
};

}  // namespace rubsweep::apps
