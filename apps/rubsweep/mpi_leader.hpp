#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "chunk_rounds.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/map/missing_cells.hpp"
#include "rubsweep/maps/map/refined_cells.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

inline constexpr std::string_view mpi_program_name = "rubsweep-mpi";

/// Results of the first rank before there is anything to share.
struct MapJob {
  RubsweepArguments arguments;
  config::RunConfig config;
  std::optional<map::MapDirectory> directory;
};

/// The first rank: deals out chunks to all ranks, itself included, and shows progress.
class MpiLeader {
 public:
  MpiLeader(MapJob& job, int ranks);

  /// Returns how many cells were finished, of all or before a signal.
  std::size_t run(int workers, const std::atomic<bool>& stop);

  /// Signal that ended the work of any rank; 0: none did.
  int signal() const { return signal_; }

  /// Cost of a refined map; empty for any other.
  std::string description() const { return refined_ ? refined_->description() : ""; }

 private:
  using Clock = std::chrono::steady_clock;

  /// A signal to one rank ends the work of all.
  void end(int signal);

  /// No cell is dealt out any more, and nobody waits for another round.
  void give_up();

  /// Deals out the next round of a refined map once all ranks wait for it, and tells them when there is none.
  /// Returns how many of the `workers` are done.
  int begin_round(int workers);

  /// Sends a rank its next chunk, or lets it wait for the next round; 1 when there is nothing left for it.
  /// With the mutex held.
  int answer(int rank);

  /// The next chunk of this rank; empty when nothing is left.
  batch::Chunk own_chunk();

  /// Cells that still run are given up, here and in the other ranks.
  [[noreturn]] void leave();

  /// Answers one report, if there is one; true when that worker is done.
  bool serve();

  void compute();

  /// Tells the refined map and the forecast of a cell that is in the log. To be called with the mutex held.
  void note(std::size_t cell, const std::string& line);

  MapJob& job_;
  std::optional<Clock::time_point> ended_;  ///< when the first signal was heard of
  int signal_ = 0;
  std::atomic<bool> ending_ = false;  ///< no new cell starts
  std::mutex mutex_;                  ///< guards the journal and what follows
  std::condition_variable next_round_;
  std::optional<map::RefinedCells> refined_;
  ChunkRounds chunks_;
  map::CellLog log_;
  std::size_t pilots_ = 0;  ///< finished cells that a forecast wants; 0: none, or no longer
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rubsweep::apps
