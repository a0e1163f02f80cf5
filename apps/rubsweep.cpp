#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "exit_code.hpp"
#include "forecast.hpp"
#include "interrupt.hpp"
#include "map_directory.hpp"
#include "program.hpp"
#include "rubsweep/batch/line_log.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/batch/progress.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/report/map_summary.hpp"
#include "rubsweep/scene/plan.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "rubsweep/sweep/explain_study.hpp"
#include "rubsweep/sweep/footprint.hpp"
#include "rubsweep/sweep/run_cells.hpp"
#include "rubsweep/sweep/untouched_walls.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {
namespace {

/// "rubsweep" or "rubsweep --shard 2/8": who others are told is at work.
std::string own_name(const RubsweepArguments& arguments) {
  if (!arguments.shard) return "rubsweep";
  return fmt::format("rubsweep --shard {}/{}", arguments.shard->index + 1, arguments.shard->count);
}

/// Runs the cells that are missing; false when it was interrupted before they were finished.
bool run_missing_cells(const RubsweepArguments& arguments, const config::RunConfig& config,
                       const MapDirectory& directory) {
  batch::Journal journal = directory.journal();
  batch::LineLog partial(directory.partial());
  const std::atomic<bool>& stop = catch_interrupts();
  const batch::ProgressMode mode = arguments.quiet ? batch::ProgressMode::never : arguments.progress;
  batch::Progress progress(directory.cells(), mode, stderr, directory.finished());
  const auto run_cells = [&](std::span<const std::size_t> cells) {
    return sweep::run_cells(
        config.study, cells, arguments.threads,
        [&](std::size_t cell, const sweep::Row& row) {
          const std::string line = report::map_line(row);
          journal.append(cell, line);
          partial.append(line);
          progress.advance();
        },
        stop);
  };
  if (std::string why = sweep::why_walls_stay_untouched(config.study, scene::make_plan(config.study.machine));
      !why.empty()) {
    why.pop_back();
    progress.say(why);
  }
  const int threads = batch::thread_count(arguments.threads);
  std::vector<std::size_t> cells = directory.missing();
  std::size_t finished = 0;
  // A few cells from all over the map tell how long it will take, where somebody is there to read it.
  if (progress.say(sweep::describe(config.study, {threads})) && cells.size() >= least_cells_to_forecast) {
    const auto pilots = sweep::take_pilot_cells(cells, pilots_per_thread * static_cast<std::size_t>(threads));
    const auto start = std::chrono::steady_clock::now();
    finished = run_cells(pilots);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    progress.say(forecast(pilots.size(), elapsed.count(), cells.size()));
  }
  finished += run_cells(cells);
  if (finished == directory.missing().size()) return true;
  progress.finish();
  fmt::print(stderr,
             "rubsweep: interrupted; {} of {} cells are finished, the same command computes the others\n",
             directory.finished() + finished, directory.cells());
  return false;
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  sweep::refuse_more_memory_than(machine_memory_bytes(), config.study,
                                 {batch::thread_count(arguments.threads)});
  const MapDirectory directory(arguments.output.value_or(config.output_directory), config, arguments.shard,
                               arguments.fresh, own_name(arguments));
  if (arguments.merge && !directory.missing().empty()) {
    throw IoError(fmt::format("nothing to merge yet: {} of {} cells are not finished",
                              directory.missing().size(), directory.cells()));
  }
  if (!arguments.quiet && !arguments.merge && directory.finished() > 0) {
    fmt::print(stderr, "rubsweep: {} of {} cells were finished before\n", directory.finished(),
               directory.cells());
  }
  if (!directory.missing().empty() && !run_missing_cells(arguments, config, directory))
    return 128 + caught_signal();
  if (arguments.shard) {
    if (!arguments.quiet)
      fmt::print("{} cells finished; when every shard is: rubsweep --merge\n", directory.cells());
    return done;
  }
  const report::MapSummary summary = directory.write_map();
  if (!arguments.quiet) fmt::print("{}map: {}\n", summary.text(), directory.map().string());
  return summary.has_failed_cells() ? some_cells_failed : done;
}

int perform(const RubsweepArguments& arguments) {
  if (answered("rubsweep", arguments.action, rubsweep_help)) return done;
  const config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  const sweep::Study& study = config.study;
  const int threads = batch::thread_count(arguments.threads);
  return act(
      arguments,
      {.size =
           [&] {
             scene::make_plan(study.machine);  // throws where no structure can be computed of these numbers
             return fmt::format("{} cells", sweep::cell_count(study.grid));
           },
       .explanation = [&] { return sweep::explain(study) + sweep::describe(study, {threads}) + "\n"; },
       .configuration = [&] { return config::print_config(config); },
       .run = [&] { return run(arguments, config); }});
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubsweep", [&] { return perform(parse_rubsweep_arguments(argc, argv)); });
}
