#include "rubsweep/batch/chunk_queue.hpp"

#include <algorithm>
#include <utility>

namespace rubsweep::batch {
namespace {

/// A few easy cells say little about the next ones.
constexpr double fastest_growth = 4;

}  // namespace

ChunkQueue::ChunkQueue(std::vector<std::size_t> cells, std::size_t workers)
    : cells_(std::move(cells)), last_(workers) {}

Chunk ChunkQueue::next(std::size_t worker, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  Last& last = last_.at(worker);
  std::size_t size = first_chunk;
  if (last.cells > 0) {
    const std::chrono::duration<double> taken = now - last.begun;
    const double growth = taken * fastest_growth > chunk_time ? chunk_time / taken : fastest_growth;
    size = std::clamp<std::size_t>(static_cast<std::size_t>(static_cast<double>(last.cells) * growth), 1,
                                   largest_chunk);
  }
  const std::size_t left = cells_.size() - dealt_;
  size = std::min({size, std::max<std::size_t>(left / (4 * last_.size()), 1), left});
  const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(dealt_);
  dealt_ += size;
  last = {size, now};
  return {begin, begin + static_cast<std::ptrdiff_t>(size)};
}

void ChunkQueue::close() {
  const std::lock_guard lock(mutex_);
  dealt_ = cells_.size();
}

}  // namespace rubsweep::batch
