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
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/map/missing_cells.hpp"
#include "rubsweep/maps/map/refined_cells.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {

inline constexpr std::string_view mpi_program_name = "rubsweep-mpi";

/// Preparation by the first rank, before anything is shared.
struct MapJob {
  RubsweepArguments arguments;
  config::RunConfig config;
  std::optional<map::MapDirectory> directory;
  std::optional<scene::PreparedMachine> prepared;  ///< machine of the study; empty: not prepared yet
};

/// The first rank: deals out chunks to all ranks including itself, and shows progress.
class MpiLeader {
 public:
  MpiLeader(MapJob& job, int ranks);

  /// Runs until all cells are finished or a signal comes. Returns the number of finished cells.
  std::size_t run(int workers, const std::atomic<bool>& stop);

  /// Signal that ended the work of any rank; 0: none.
  int signal() const { return signal_; }

  /// Cost of a refined map; empty for other maps.
  std::string description() const { return refined_ ? refined_->description() : ""; }

 private:
  using Clock = std::chrono::steady_clock;

  /// Ends the work of all ranks after a signal to one of them.
  void end(int signal);

  /// Stops dealing out cells, and wakes up everybody who waits for another round.
  void give_up();

  /// Starts the next round of a refined map once all ranks wait for it; if there is none, informs them.
  /// Returns how many of the `workers` are done.
  int begin_round(int workers);

  /// Sends a rank its next chunk, or makes it wait for the next round. Returns 1 if there is no more work for
  /// it, else 0. The mutex must be held.
  int answer(int rank);

  /// The next chunk of this rank; empty if there is no more work.
  batch::Chunk own_chunk();

  /// Ends all ranks without waiting for cells that still run.
  [[noreturn]] void leave();

  /// Answers one report, if there is one; returns true if its worker is done.
  bool serve();

  void compute();

  /// Passes a logged cell on to the refined map and the forecast. The mutex must be held.
  void note(std::size_t cell, const std::string& line);

  MapJob& job_;
  std::optional<Clock::time_point> ended_;  ///< time of the first signal, if there was one
  int signal_ = 0;
  std::atomic<bool> ending_ = false;  ///< no new cell begins
  std::mutex mutex_;                  ///< guards the journal and the members below
  std::condition_variable next_round_;
  std::optional<map::RefinedCells> refined_;
  ChunkRounds chunks_;
  map::CellLog log_;
  std::size_t pilots_ = 0;  ///< number of cells needed for a forecast; 0: none, or it is already made
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rubsweep::apps
