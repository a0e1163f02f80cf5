#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <string>
#include <vector>

#include "exit_code.hpp"
#include "forecast.hpp"
#include "interrupt.hpp"
#include "kept_files.hpp"
#include "map_directory.hpp"
#include "map_outcome.hpp"
#include "missing_cells.hpp"
#include "premises.hpp"
#include "program.hpp"
#include "refined_cells.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/describe_footprint.hpp"
#include "rubsweep/report/explain_study.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/sweep/footprint.hpp"
#include "rubsweep_arguments.hpp"
#include "verified_directory.hpp"

namespace rubsweep::apps {
namespace {

/// "rubsweep" or "rubsweep --shard 2/8": who others are told is at work.
std::string own_name(const RubsweepArguments& arguments) {
  if (!arguments.shard) return "rubsweep";
  return fmt::format("rubsweep --shard {}/{}", arguments.shard->index + 1, arguments.shard->count);
}

/// A refined map knows what it still wants only by what it has.
void refuse_to_merge_too_early(const config::RunConfig& config, const MapDirectory& directory) {
  std::size_t wanted = directory.missing().size();
  if (config.study.grid.refinement) {
    RefinedCells known(config.study.grid);
    known.read(directory);
    wanted = known.wanted().size();
    if (wanted > 0) {
      throw IoError(
          fmt::format("nothing to merge yet: the refined map wants {} cells more, allowed: every shard once "
                      "more, or the same without --shard",
                      wanted));
    }
  }
  if (wanted > 0) {
    throw IoError(
        fmt::format("nothing to merge yet: {} of {} cells are not finished", wanted, directory.cells()));
  }
}

std::string shard_is_done(const sweep::Grid& grid, const MapDirectory& directory,
                          std::size_t left_to_others) {
  if (left_to_others > 0) {
    return fmt::format(
        "the refined map wants {} cells of other shards before it can say what it wants of this one: "
        "run every shard, then each once more, or rubsweep without --shard\n",
        left_to_others);
  }
  if (grid.refinement) return "the refined map is complete: rubsweep --merge\n";
  return fmt::format("{} cells finished; when every shard is: rubsweep --merge\n", directory.cells());
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  refuse_fading(arguments, config.study);
  report::refuse_more_memory_than(machine_memory_bytes(), config.study,
                                  {batch::thread_count(arguments.threads)});
  batch::require_threads(arguments.threads, 1);
  const std::filesystem::path output = arguments.output.value_or(config.output_directory);
  keep_run_configuration(arguments.config, output);
  MapDirectory directory(output, config, arguments.shard, arguments.fresh, own_name(arguments));
  if (directory.finished_map()) {
    if (!arguments.quiet) say(map_is_there("rubsweep"));
    return report_map("rubsweep", arguments, directory.finished_map()->summary, config, directory);
  }
  if (arguments.merge) {
    refuse_to_merge_too_early(config, directory);
    return report_map("rubsweep", arguments, directory.write_map(), config, directory);
  }
  const SweepRun how{"rubsweep", arguments.threads, arguments.progress, arguments.quiet};
  const auto left_to_others = compute_missing_cells(how, config.study, directory);
  if (!left_to_others) return 128 + caught_signal();
  if (arguments.shard) {
    if (!arguments.quiet) fmt::print("{}", shard_is_done(config.study.grid, directory, *left_to_others));
    return done;
  }
  return report_map("rubsweep", arguments, directory.write_map(), config, directory);
}

int verify(const RubsweepArguments& arguments) {
  const DirectoryVerdict verdict = verify_directory(*arguments.verified);
  const auto list = [&](const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) say(fmt::format("rubsweep: {}\n", sentence));
  };
  list(verdict.faults);
  if (!arguments.quiet) list(verdict.remarks);
  if (!arguments.quiet && verdict.faults.empty()) {
    fmt::print("{}: whole: {}\n", arguments.verified->string(), fmt::join(verdict.files, " "));
  }
  return verdict.faults.empty() ? done : not_whole;
}

int perform(const RubsweepArguments& arguments) {
  if (arguments.verified) return verify(arguments);
  if (answered("rubsweep", arguments.action, rubsweep_help)) return done;
  const config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  ask("rubsweep", config.questions, arguments.quiet);
  const sweep::Study& study = config.study;
  const int threads = batch::thread_count(arguments.threads);
  return act(
      arguments,
      {.size =
           [&] {
             // Throws where no structure can be computed of these numbers.
             warn_of_premises("rubsweep", study, scene::prepare_machine(study.machine));
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
