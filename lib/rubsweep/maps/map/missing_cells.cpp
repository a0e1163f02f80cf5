#include "rubsweep/maps/map/missing_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/map/refined_cells.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/sweep/run_cells.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"

namespace rubsweep::map {
namespace {

/// Time between two readings of the journals of other shards.
constexpr std::chrono::milliseconds shard_patience{500};

/// Shortest time for which a shard without work waits for other shards, because shards started by one command
/// do not begin at the same instant.
constexpr std::chrono::seconds beginners_patience{5};

}  // namespace

CellLog::CellLog(const MapDirectory& directory, batch::ProgressMode mode)
    : directory_(directory),
      journal_(directory.journal()),
      partial_(directory.partial()),
      progress_(directory.cells(), mode, stderr, directory.finished()) {}

void CellLog::add(std::size_t cell, const std::string& line, std::optional<double> seconds) {
  journal_.append(cell, line);
  show(cell, line, seconds);
}

void CellLog::add_of_other_process(std::size_t cell, const std::string& line) { show(cell, line, {}); }

void CellLog::show(std::size_t cell, const std::string& line, std::optional<double> seconds) {
  partial_.append(directory_.in_map(line));
  ++finished_;
  progress_.finish_cell(cell, seconds);
}

void CellLog::refresh() {
  progress_.refresh();
  journal_.refresh();
}

void CellLog::close() {
  journal_.sync();
  progress_.finish();
}

std::string interrupted_map(std::string_view program, const MapDirectory& directory, std::size_t finished) {
  return fmt::format("{}: interrupted; {} of {} cells are finished, the same command computes the others\n",
                     program, directory.finished() + finished, directory.cells());
}

MissingCells::MissingCells(const ComputeOptions& options, const sweep::Study& study, MapDirectory& directory)
    : threads_(options.threads),
      study_(study),
      prepared_(options.prepared),
      directory_(directory),
      program_(options.program),
      stop_(options.stop ? *options.stop : never_),
      log_(directory, options.progress) {
  // The cells that a refined map needs are not known beforehand.
  if (study.grid.refinement) return;
  const std::size_t speeds = study.grid.speed_hz.size();
  log_.progress().expect({speeds, sweep::cell_count(study.grid) / speeds, directory.missing()});
}

/// Computes the cells of a refined map in rounds: each round needs the labels of the round before. Shards
/// that run at the same time wait for each other's cells.
bool MissingCells::run_refined() {
  RefinedCells known(study_.grid);
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
      alone = true;  // reads once more, because other shards may have written before they ended
    } else {
      left_to_others_ = wanted.size();
      break;
    }
  }
  const std::lock_guard lock(mutex_);
  complete_ = !stop_;
  if (!complete_) return false;
  log_.progress().finish();
  if (left_to_others_ == 0) description_ = known.description();
  return true;
}

/// Computes a few cells spread over the map first, to predict the total time.
void MissingCells::run_pilots(std::vector<std::size_t>& cells, std::size_t pilots_wanted,
                              const std::string& hint) {
  const auto pilots = sweep::take_pilot_cells(cells, pilots_wanted);
  const auto start = std::chrono::steady_clock::now();
  run_cells(pilots);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  const std::string text = batch::forecast(pilots.size(), elapsed.count(), cells.size());
  if (text.empty()) return;
  say_progress(text);
  if (!hint.empty()) say_progress(hint);
}

const scene::PreparedMachine& MissingCells::prepared() {
  if (!prepared_) prepared_ = scene::prepare_machine(study_.machine);
  return *prepared_;
}

bool MissingCells::run() {
  if (study_.grid.refinement) return run_refined();
  const double slowest_hz = *std::ranges::min_element(study_.grid.speed_hz);
  for (std::string why : {sweep::why_torsion_is_idle(prepared(), slowest_hz),
                          sweep::why_walls_stay_untouched(study_, prepared())}) {
    if (why.empty()) continue;
    why.pop_back();
    say_progress(why);
  }
  const int threads = batch::thread_count(threads_);
  std::vector<std::size_t> cells = directory_.missing();
  const std::size_t pilots_wanted = batch::pilot_count(cells.size(), static_cast<std::size_t>(threads));
  // Only where a person reads the output.
  if (say_progress(report::describe_footprint(study_, prepared(), {threads})) && pilots_wanted > 0)
    run_pilots(cells, pilots_wanted, sweep::describe_many_modes(prepared()));
  run_cells(cells);
  const std::lock_guard lock(mutex_);
  return all_finished();
}

void MissingCells::run_cells(std::span<const std::size_t> cells) {
  const batch::LapTime time;
  sweep::run_cells(
      study_, prepared(), cells, threads_,
      [&](std::size_t cell, const sweep::Row& row) { write_down(cell, row, time.lap_s()); }, stop_);
}

void MissingCells::write_down(std::size_t cell, const sweep::Row& row, double seconds) {
  const std::string line = report::map_line(row, study_);
  const std::lock_guard lock(mutex_);
  if (!given_up_) log_.add(cell, line, seconds);
}

bool MissingCells::say_progress(const std::string& text) {
  const std::lock_guard lock(mutex_);
  return log_.progress().say(text);
}

void MissingCells::refresh() {
  const std::lock_guard lock(mutex_);
  log_.refresh();
}

bool MissingCells::give_up() {
  const std::lock_guard lock(mutex_);
  if (complete_ || (!study_.grid.refinement && all_finished())) return false;
  given_up_ = true;
  log_.close();
  directory_.leave();
  return true;
}

std::string MissingCells::interrupted() {
  const std::lock_guard lock(mutex_);
  if (!given_up_) log_.close();
  return interrupted_map(program_, directory_, log_.finished());
}

std::optional<report::MapSummary> compute(const config::RunConfig& config,
                                          const std::filesystem::path& directory,
                                          const ComputeOptions& options) {
  MapDirectory map(directory, config, std::nullopt, false, options.program);
  if (map.finished_map()) return map.finished_map()->summary;
  if (MissingCells missing(options, config.study, map); !missing.run()) return std::nullopt;
  const report::MapSummary summary = map.write_map();
  map.paint(config.study.grid);
  return summary;
}

}  // namespace rubsweep::map
