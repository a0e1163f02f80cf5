#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::apps {

/// Chunks of cells for the workers of one map, who count from 0. A map in rounds, which a refined one is,
/// knows the cells of the next round when all of the present one are finished: whoever has nothing to do
/// before that waits. Not for several threads at once.
class ChunkRounds {
 public:
  /// `more`: other rounds may follow the one with these cells.
  ChunkRounds(std::vector<std::size_t> cells, std::size_t workers, bool more);

  /// The next cells for a worker that has finished its last chunk: none when there is nothing left to do,
  /// nothing at all when it has to wait for the next round.
  std::optional<batch::Chunk> next(std::size_t worker);

  bool waits(std::size_t worker) const;
  std::size_t waiting() const { return waiting_.size(); }

  /// Workers that wait, in the order in which they began to; they are to ask again.
  std::vector<std::size_t> take_waiting();

  /// Deals out the cells of the next round; without any it was the last.
  void begin_round(std::vector<std::size_t> cells);

  /// Nothing more is dealt out, and no other round comes.
  void give_up();

  /// Whether no other round comes.
  bool is_last() const { return !more_; }

 private:
  batch::ChunkQueue chunks_;
  bool more_;
  std::vector<std::size_t> waiting_;
};

}  // namespace rubsweep::apps
