#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
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
                       MapDirectory& directory) {
  batch::Journal journal = directory.journal();
  batch::LineLog partial(directory.partial());
  const std::atomic<bool>& stop = catch_interrupts();
  const batch::ProgressMode mode = arguments.quiet ? batch::ProgressMode::never : arguments.progress;
  batch::Progress progress(directory.cells(), mode, stderr, directory.finished());
  std::mutex mutex;  // guards journal, partial, progress and finished
  std::size_t finished = 0;
  const auto complain = [&] {
    progress.finish();
    say(fmt::format(
        "rubsweep: interrupted; {} of {} cells are finished, the same command computes the others\n",
        directory.finished() + finished, directory.cells()));
  };
  const auto tick = [&] {
    const std::lock_guard lock(mutex);
    progress.refresh();
  };
  const auto say_progress = [&](const std::string& text) {
    const std::lock_guard lock(mutex);
    return progress.say(text);
  };
  // Cells that still run are given up: nothing of them is in the journal, and nothing can get there any more.
  const auto leave = [&] {
    const std::lock_guard lock(mutex);
    if (finished == directory.missing().size()) return;
    complain();
    directory.leave();
    std::_Exit(128 + caught_signal());
  };
  const auto run_cells = [&](std::span<const std::size_t> cells) {
    return sweep::run_cells(
        config.study, cells, arguments.threads,
        [&](std::size_t cell, const sweep::Row& row) {
          const std::string line = report::map_line(row);
          const std::lock_guard lock(mutex);
          journal.append(cell, line);
          partial.append(line);
          progress.advance();
          ++finished;
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
  std::optional<Watch> watch(std::in_place, tick, leave);
  // A few cells from all over the map tell how long it will take, where somebody is there to read it.
  if (say_progress(sweep::describe(config.study, {threads})) && cells.size() >= least_cells_to_forecast) {
    const auto pilots = sweep::take_pilot_cells(cells, pilots_per_thread * static_cast<std::size_t>(threads));
    const auto start = std::chrono::steady_clock::now();
    run_cells(pilots);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    say_progress(forecast(pilots.size(), elapsed.count(), cells.size()));
  }
  run_cells(cells);
  watch.reset();
  if (finished == directory.missing().size()) return true;
  complain();
  return false;
}

/// What is said of a whole map and its exit code, whoever computed it.
int report_map(const RubsweepArguments& arguments, const report::MapSummary& summary,
               const MapDirectory& directory) {
  if (!arguments.quiet) fmt::print("{}map: {}\n", summary.text(), directory.map().string());
  return summary.has_failed_cells() ? some_cells_failed : done;
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  sweep::refuse_more_memory_than(machine_memory_bytes(), config.study,
                                 {batch::thread_count(arguments.threads)});
  batch::require_threads(arguments.threads, 1);
  MapDirectory directory(arguments.output.value_or(config.output_directory), config, arguments.shard,
                         arguments.fresh, own_name(arguments));
  if (directory.finished_map()) {
    if (!arguments.quiet) say(map_is_there("rubsweep"));
    return report_map(arguments, directory.finished_map()->summary, directory);
  }
  if (arguments.merge && !directory.missing().empty()) {
    throw IoError(fmt::format("nothing to merge yet: {} of {} cells are not finished",
                              directory.missing().size(), directory.cells()));
  }
  if (!arguments.quiet && !arguments.merge && directory.finished() > 0) {
    say(fmt::format("rubsweep: {} of {} cells were finished before\n", directory.finished(),
                    directory.cells()));
  }
  if (!directory.missing().empty() && !run_missing_cells(arguments, config, directory))
    return 128 + caught_signal();
  if (arguments.shard) {
    if (!arguments.quiet)
      fmt::print("{} cells finished; when every shard is: rubsweep --merge\n", directory.cells());
    return done;
  }
  return report_map(arguments, directory.write_map(), directory);
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
