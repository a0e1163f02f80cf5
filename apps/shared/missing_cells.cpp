#include "shared/missing_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/batch/lap_time.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/map/refined_cells.hpp"
#include "rubsweep/maps/report/describe_footprint.hpp"
#include "rubsweep/maps/report/describe_modes.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/footprint.hpp"
#include "rubsweep/maps/sweep/idle_torsion.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"
#include "rubsweep/maps/sweep/untouched_walls.hpp"
#include "shared/forecast.hpp"
#include "shared/interrupt.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

/// Until the journals of other shards are read again.
constexpr std::chrono::milliseconds shard_patience{500};

/// Shards that were begun with one command are not there at one instant, and the first may have no more to do
/// before the last has begun.
constexpr std::chrono::seconds beginners_patience{5};

}  // namespace

MissingCells::MissingCells(const SweepRun& how, const sweep::Study& study, map::MapDirectory& directory)
    : how_(how),
      study_(study),
      directory_(directory),
      stop_(catch_interrupts()),
      log_(directory, how.quiet ? batch::ProgressMode::never : how.progress) {
  // Which cells a refinement wants is not known beforehand.
  if (study.grid.refinement) return;
  const std::size_t speeds = study.grid.speed_hz.size();
  log_.progress().expect({speeds, sweep::cell_count(study.grid) / speeds, directory.missing()});
}

/// Computes round after round of the cells that the refinement of those before needs. Shards at work at the
/// same time wait for each other's.
bool MissingCells::run_refined() {
  map::RefinedCells known(study_.grid);
  std::optional<Watch> watch(
      std::in_place, [this] { refresh(); }, [this] { leave(); });
  bool alone = false;
  const auto begun = std::chrono::steady_clock::now();
  while (!stop_) {
    known.read(directory_);
    std::vector<std::size_t> wanted = known.wanted(), own = wanted;
    std::erase_if(own, [&](std::size_t cell) { return !directory_.has_in_share(cell); });
    if (!own.empty()) {
      alone = false;
      run_cells(own);
    } else if (directory_.is_at_work_on(wanted) ||
               (!wanted.empty() && std::chrono::steady_clock::now() - begun < beginners_patience)) {
      alone = false;
      std::this_thread::sleep_for(shard_patience);
    } else if (!wanted.empty() && !alone) {
      alone = true;  // what others wrote before they left is read once more
    } else {
      left_to_others_ = wanted.size();
      break;
    }
  }
  {
    const std::lock_guard lock(mutex_);
    complete_ = !stop_;
  }
  watch.reset();
  if (stop_) {
    say_interrupted();
    return false;
  }
  log_.progress().finish();
  if (!how_.quiet && left_to_others_ == 0) say(known.description());
  return true;
}

bool MissingCells::run() {
  if (study_.grid.refinement) return run_refined();
  const scene::PreparedMachine prepared = scene::prepare_machine(study_.machine);
  const double slowest_hz = *std::ranges::min_element(study_.grid.speed_hz);
  for (std::string why : {sweep::why_torsion_is_idle(prepared, slowest_hz),
                          sweep::why_walls_stay_untouched(study_, prepared)}) {
    if (why.empty()) continue;
    why.pop_back();
    log_.progress().say(why);
  }
  const int threads = batch::thread_count(how_.threads);
  std::vector<std::size_t> cells = directory_.missing();
  std::optional<Watch> watch(
      std::in_place, [this] { refresh(); }, [this] { leave(); });
  // A few cells from all over the map tell how long it will take, where somebody is there to read it.
  const std::size_t pilots_wanted = pilot_count(cells.size(), static_cast<std::size_t>(threads));
  if (say_progress(report::describe_footprint(study_, prepared, {threads})) && pilots_wanted > 0) {
    const auto pilots = sweep::take_pilot_cells(cells, pilots_wanted);
    const auto start = std::chrono::steady_clock::now();
    run_cells(pilots);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (const std::string text = forecast(pilots.size(), elapsed.count(), cells.size()); !text.empty()) {
      say_progress(text);
      if (std::string hint = report::describe_many_modes(prepared); !hint.empty()) say_progress(hint);
    }
  }
  run_cells(cells);
  watch.reset();
  if (all_finished()) return true;
  say_interrupted();
  return false;
}

void MissingCells::run_cells(std::span<const std::size_t> cells) {
  const batch::LapTime time;
  sweep::run_cells(
      study_, cells, how_.threads,
      [&](std::size_t cell, const sweep::Row& row) { write_down(cell, row, time.lap_s()); }, stop_);
}

void MissingCells::write_down(std::size_t cell, const sweep::Row& row, double seconds) {
  const std::string line = report::map_line(row, study_);
  const std::lock_guard lock(mutex_);
  log_.add(cell, line, seconds);
}

bool MissingCells::say_progress(const std::string& text) {
  const std::lock_guard lock(mutex_);
  return log_.progress().say(text);
}

void MissingCells::refresh() {
  const std::lock_guard lock(mutex_);
  log_.refresh();
}

/// Nothing can get into the journal any more once the mutex is held.
void MissingCells::leave() {
  const std::lock_guard lock(mutex_);
  if (complete_ || (!study_.grid.refinement && all_finished())) return;
  say_interrupted();
  directory_.leave();
  std::_Exit(128 + caught_signal());
}

void MissingCells::say_interrupted() {
  log_.close();
  say(map::interrupted_map(how_.program, directory_, log_.finished()));
}

std::optional<std::size_t> compute_missing_cells(const SweepRun& how, const sweep::Study& study,
                                                 map::MapDirectory& directory) {
  if (!how.quiet && directory.finished() > 0) {
    say(fmt::format("{}: {} of {} cells were finished before\n", how.program, directory.finished(),
                    directory.cells()));
  }
  if (directory.missing().empty() && !study.grid.refinement) return 0;
  if (!how.quiet) warn_of_premises(how.program, study, scene::prepare_machine(study.machine));
  MissingCells missing(how, study, directory);
  if (!missing.run()) return std::nullopt;
  return missing.left_to_others();
}

}  // namespace rubsweep::apps
