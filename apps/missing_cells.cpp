#include "missing_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "forecast.hpp"
#include "interrupt.hpp"
#include "program.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/report/describe_footprint.hpp"
#include "rubsweep/report/describe_refinement.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/report/map_summary.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/sweep/footprint.hpp"
#include "rubsweep/sweep/idle_torsion.hpp"
#include "rubsweep/sweep/run_cells.hpp"
#include "rubsweep/sweep/untouched_walls.hpp"

namespace rubsweep::apps {

MissingCells::MissingCells(const SweepRun& how, const sweep::Study& study, MapDirectory& directory)
    : how_(how),
      study_(study),
      directory_(directory),
      stop_(catch_interrupts()),
      journal_(directory.journal()),
      partial_(directory.partial()),
      progress_(directory.cells(), how.quiet ? batch::ProgressMode::never : how.progress, stderr,
                directory.finished()) {}

/// Round after round of the cells that those before them ask for.
bool MissingCells::run_refined() {
  const auto number_of = [&](const std::string& line) {
    return numbers_.try_emplace(report::label_of(line), static_cast<int>(numbers_.size())).first->second;
  };
  labels_.assign(sweep::cell_count(study_.grid), sweep::unknown_label);
  std::optional<Watch> watch(
      std::in_place, [this] { refresh(); }, [this] { leave(); });
  while (true) {
    directory_.for_each_finished(
        [&](std::size_t cell, const std::string& line) { labels_[cell] = number_of(line); });
    const std::vector<std::size_t> wanted = sweep::wanted_cells(study_.grid, labels_);
    if (wanted.empty()) break;
    run_cells(wanted);
    if (stop_) {
      watch.reset();
      say_interrupted();
      return false;
    }
  }
  {
    const std::lock_guard lock(mutex_);
    complete_ = true;
  }
  watch.reset();
  progress_.finish();
  if (!how_.quiet) say(report::describe_refinement(study_.grid, labels_));
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
    progress_.say(why);
  }
  const int threads = batch::thread_count(how_.threads);
  std::vector<std::size_t> cells = directory_.missing();
  std::optional<Watch> watch(
      std::in_place, [this] { refresh(); }, [this] { leave(); });
  // A few cells from all over the map tell how long it will take, where somebody is there to read it.
  if (say_progress(report::describe_footprint(study_, {threads})) &&
      cells.size() >= least_cells_to_forecast) {
    const auto pilots = sweep::take_pilot_cells(cells, pilots_per_thread * static_cast<std::size_t>(threads));
    const auto start = std::chrono::steady_clock::now();
    run_cells(pilots);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    say_progress(forecast(pilots.size(), elapsed.count(), cells.size()));
  }
  run_cells(cells);
  watch.reset();
  if (all_finished()) return true;
  say_interrupted();
  return false;
}

void MissingCells::run_cells(std::span<const std::size_t> cells) {
  sweep::run_cells(
      study_, cells, how_.threads, [this](std::size_t cell, const sweep::Row& row) { write_down(cell, row); },
      stop_);
}

void MissingCells::write_down(std::size_t cell, const sweep::Row& row) {
  const std::string line = report::map_line(row, study_);
  const std::lock_guard lock(mutex_);
  journal_.append(cell, line);
  partial_.append(line);
  progress_.advance();
  ++finished_;
}

bool MissingCells::say_progress(const std::string& text) {
  const std::lock_guard lock(mutex_);
  return progress_.say(text);
}

void MissingCells::refresh() {
  const std::lock_guard lock(mutex_);
  progress_.refresh();
}

/// Nothing can get into the journal any more once the mutex is held.
void MissingCells::leave() {
  const std::lock_guard lock(mutex_);
  if (all_finished() || complete_) return;
  say_interrupted();
  directory_.leave();
  std::_Exit(128 + caught_signal());
}

void MissingCells::say_interrupted() {
  progress_.finish();
  say(fmt::format("{}: interrupted; {} of {} cells are finished, the same command computes the others\n",
                  how_.program, directory_.finished() + finished_, directory_.cells()));
}

bool compute_missing_cells(const SweepRun& how, const sweep::Study& study, MapDirectory& directory) {
  if (!how.quiet && directory.finished() > 0) {
    say(fmt::format("{}: {} of {} cells were finished before\n", how.program, directory.finished(),
                    directory.cells()));
  }
  return directory.missing().empty() || MissingCells(how, study, directory).run();
}

}  // namespace rubsweep::apps
