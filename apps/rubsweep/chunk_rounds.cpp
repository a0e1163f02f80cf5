#include "chunk_rounds.hpp"

#include <algorithm>
#include <utility>

namespace rubsweep::apps {

ChunkRounds::ChunkRounds(std::vector<std::size_t> cells, std::size_t workers, bool more)
    : chunks_(std::move(cells), workers), more_(more) {}

std::optional<batch::Chunk> ChunkRounds::next(std::size_t worker) {
  batch::Chunk chunk = chunks_.next(worker);
  if (!chunk.empty() || !more_) return chunk;
  if (!waits(worker)) waiting_.push_back(worker);
  return std::nullopt;
}

bool ChunkRounds::waits(std::size_t worker) const {
  return std::ranges::find(waiting_, worker) != waiting_.end();
}

std::vector<std::size_t> ChunkRounds::take_waiting() { return std::exchange(waiting_, {}); }

void ChunkRounds::begin_round(std::vector<std::size_t> cells) {
  more_ = !cells.empty();
  chunks_.refill(std::move(cells));
}

void ChunkRounds::give_up() {
  more_ = false;
  chunks_.close();
}

}  // namespace rubsweep::apps
