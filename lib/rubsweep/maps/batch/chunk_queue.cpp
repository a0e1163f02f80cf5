#include "rubsweep/maps/batch/chunk_queue.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

namespace rubsweep::batch {
namespace {

/// A few easy cells say little about the next ones.
constexpr double fastest_growth = 4;

/// Divisor of the smallest chunk: towards the end shorter ones would cost more than an uneven end.
constexpr std::size_t least_share = 16;

/// About the golden section of `count`, whose multiples are spread as evenly as can be however many there
/// are, and without a common divisor with it.
std::size_t spreading_stride(std::size_t count) {
  auto stride = static_cast<std::size_t>(static_cast<double>(count) / std::numbers::phi);
  while (std::gcd(stride, count) > 1) ++stride;
  return std::max<std::size_t>(stride, 1);
}

}  // namespace

ChunkQueue::ChunkQueue(std::vector<std::size_t> cells, std::size_t workers)
    : cells_(std::move(cells)), stride_(spreading_stride(cells_.size())), last_(workers) {}

Chunk ChunkQueue::next(std::size_t worker, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (dealt_ == cells_.size()) return {};
  Last& last = last_.at(worker);
  std::size_t size = first_chunk;
  if (last.cells > 0) {
    const std::chrono::duration<double> taken = now - last.begun;
    const double growth = taken * fastest_growth > chunk_time ? chunk_time / taken : fastest_growth;
    size = std::clamp<std::size_t>(static_cast<std::size_t>(static_cast<double>(last.cells) * growth), 1,
                                   largest_chunk);
  }
  const std::size_t left = cells_.size() - dealt_;
  size = std::min({size, std::max<std::size_t>({left / (4 * last_.size()), size / least_share, 1}), left});
  Chunk chunk;
  chunk.reserve(size);
  for (; chunk.size() < size; ++dealt_) chunk.push_back(cells_[dealt_ * stride_ % cells_.size()]);
  last = {size, now};
  return chunk;
}

void ChunkQueue::refill(std::vector<std::size_t> cells) {
  const std::lock_guard lock(mutex_);
  cells_ = std::move(cells);
  stride_ = spreading_stride(cells_.size());
  dealt_ = 0;
}

void ChunkQueue::close() {
  const std::lock_guard lock(mutex_);
  dealt_ = cells_.size();
}

}  // namespace rubsweep::batch
