#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::apps {

/// Gives chunks of cells to the workers of one map, which are numbered from 0. A refined map is computed in
/// rounds: the cells of the next round are known only when all cells of the present round are finished. A
/// worker without work waits until then. Only one thread at a time may use it.
class ChunkRounds {
 public:
  /// `more`: further rounds may follow after these cells.
  ChunkRounds(std::vector<std::size_t> cells, std::size_t workers, bool more);

  /// The next cells for a worker that has finished its last chunk. An empty chunk: there is no more work.
  /// std::nullopt: the worker must wait for the next round.
  std::optional<batch::Chunk> next(std::size_t worker);

  bool waits(std::size_t worker) const;
  std::size_t waiting() const { return waiting_.size(); }

  /// Returns the waiting workers in the order of their arrival and clears the list; each has to ask again.
  std::vector<std::size_t> take_waiting();

  /// Starts a round with these cells; an empty list means that there are no more rounds.
  void begin_round(std::vector<std::size_t> cells);

  /// Stops: no more cells are dealt out, and no round follows.
  void give_up();

  /// Whether no further round follows.
  bool is_last() const { return !more_; }

 private:
  batch::ChunkQueue chunks_;
  bool more_;
  std::vector<std::size_t> waiting_;
};

}  // namespace rubsweep::apps
