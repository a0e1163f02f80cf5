#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "exit_code.hpp"
#include "forecast.hpp"
#include "interrupt.hpp"
#include "map_directory.hpp"
#include "missing_cells.hpp"
#include "program.hpp"
#include "report_file.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/describe_footprint.hpp"
#include "rubsweep/report/describe_refinement.hpp"
#include "rubsweep/report/explain_study.hpp"
#include "rubsweep/report/map_summary.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/sweep/footprint.hpp"
#include "rubsweep_arguments.hpp"
#include "terminal_map.hpp"

namespace rubsweep::apps {
namespace {

/// "rubsweep" or "rubsweep --shard 2/8": who others are told is at work.
std::string own_name(const RubsweepArguments& arguments) {
  if (!arguments.shard) return "rubsweep";
  return fmt::format("rubsweep --shard {}/{}", arguments.shard->index + 1, arguments.shard->count);
}

/// What is said of a whole map and its exit code, whoever computed it.
int report_map(const RubsweepArguments& arguments, const report::MapSummary& summary,
               const sweep::Study& study, MapDirectory& directory) {
  const bool shown = !arguments.quiet && arguments.progress != batch::ProgressMode::never;
  const TerminalView view =
      shown ? terminal_view(directory.map(), study.grid, arguments.report) : TerminalView{};
  if (!arguments.quiet) fmt::print("{}{}map: {}\n", view.map, summary.text(), directory.map().string());
  if (!arguments.quiet) warn("rubsweep", summary);
  if (arguments.figure) {
    arguments.figure->draw("draw_domain_map.py", directory.map(),
                           study.machine.kick ? "Rub domains after a kick" : "Rub domains");
    if (!arguments.quiet) fmt::print("figure: {}\n", arguments.figure->file().string());
  }
  if (arguments.report) {
    const std::filesystem::path place = directory.map().parent_path();
    const int code = write_report(place, study, "rubsweep",
                                  {.file = place / "report.html",
                                   .threads = arguments.threads,
                                   .progress = arguments.progress,
                                   .quiet = arguments.quiet,
                                   .before_leaving = [&] { directory.leave(); }});
    if (code != done) return code;
  }
  fmt::print("{}", view.next);
  return summary.has_failed_cells() ? some_cells_failed : done;
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  if (arguments.shard || arguments.merge) report::refuse_refinement(config.study.grid, "a map in shards");
  if (arguments.report) report::refuse_refinement(config.study.grid, "a report");
  report::refuse_more_memory_than(machine_memory_bytes(), config.study,
                                  {batch::thread_count(arguments.threads)});
  batch::require_threads(arguments.threads, 1);
  MapDirectory directory(arguments.output.value_or(config.output_directory), config, arguments.shard,
                         arguments.fresh, own_name(arguments));
  if (directory.finished_map()) {
    if (!arguments.quiet) say(map_is_there("rubsweep"));
    return report_map(arguments, directory.finished_map()->summary, config.study, directory);
  }
  if (arguments.merge && !directory.missing().empty()) {
    throw IoError(fmt::format("nothing to merge yet: {} of {} cells are not finished",
                              directory.missing().size(), directory.cells()));
  }
  const SweepRun how{"rubsweep", arguments.threads, arguments.progress, arguments.quiet};
  if (!arguments.merge && !compute_missing_cells(how, config.study, directory)) return 128 + caught_signal();
  if (arguments.shard) {
    if (!arguments.quiet)
      fmt::print("{} cells finished; when every shard is: rubsweep --merge\n", directory.cells());
    return done;
  }
  return report_map(arguments, directory.write_map(), config.study, directory);
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
             scene::prepare_machine(
                 study.machine);  // throws where no structure can be computed of these numbers
             return fmt::format("{} cells", sweep::cell_count(study.grid));
           },
       .explanation =
           [&] { return report::explain_study(study) + report::describe_footprint(study, {threads}) + "\n"; },
       .configuration = [&] { return config::print_config(config); },
       .run = [&] { return run(arguments, config); }});
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubsweep", [&] { return perform(parse_rubsweep_arguments(argc, argv)); });
}
