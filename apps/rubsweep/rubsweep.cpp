#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "explain/explain_study.hpp"
#include "map_outcome.hpp"
#include "map_status.hpp"
#include "merge.hpp"
#include "motion_kinds_csv.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep_arguments.hpp"
#include "shared/child_process.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/missing_cells.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/study_questions.hpp"
#include "shared/verdict.hpp"
#include "shared/written_file.hpp"
#include "watched_map.hpp"

namespace rubsweep::apps {
namespace {

/// Name of this process in messages to others: "rubsweep" or "rubsweep --shard 2/8".
std::string own_name(const RubsweepArguments& arguments) {
  if (!arguments.shard) return "rubsweep";
  return fmt::format("rubsweep --shard {}/{}", arguments.shard->index + 1, arguments.shard->count);
}

std::string shard_is_done(const RubsweepArguments& arguments, const sweep::Grid& grid,
                          const map::MapDirectory& directory, std::size_t left_to_others) {
  if (left_to_others > 0) {
    return fmt::format(
        "the refined map wants {} cells of other shards before it can say what it wants of this one: "
        "run every shard, then each once more, or all of it by\n  {}\n",
        left_to_others, command_of(arguments, ""));
  }
  const std::string merge = command_of(arguments, "--merge");
  if (grid.refinement) return fmt::format("the refined map is complete: {}\n", merge);
  return fmt::format("{} cells finished; when every shard is: {}\n", directory.cells(), merge);
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  refuse_fading(arguments, config.study);
  report::refuse_more_memory_than(batch::machine_memory_bytes(), config.study,
                                  {batch::thread_count(arguments.threads)});
  batch::require_threads(arguments.threads, 1);
  const std::filesystem::path output = arguments.output.value_or(config.output_directory);
  keep_run_configuration(arguments.config, output);
  refuse_what_cannot_be_shown(arguments, config.study, output);
  map::MapDirectory directory(output, config, arguments.shard, arguments.fresh, own_name(arguments));
  if (directory.finished_map()) {
    if (!arguments.quiet) say(map::map_is_there("rubsweep"));
    return report_map("rubsweep", arguments, directory.finished_map()->summary, config, directory);
  }
  if (arguments.merge) {
    refuse_to_merge_too_early(arguments, config, directory);
    return report_map("rubsweep", arguments, directory.write_map(), config, directory);
  }
  const SweepRun how{"rubsweep", arguments.threads, arguments.progress, arguments.quiet};
  const auto left_to_others = compute_missing_cells(how, config.study, directory);
  if (!left_to_others) return 128 + caught_signal();
  if (arguments.shard) {
    if (!arguments.quiet)
      print("{}", shard_is_done(arguments, config.study.grid, directory, *left_to_others));
    return *left_to_others > 0 ? unfinished : done;
  }
  return report_map("rubsweep", arguments, directory.write_map(), config, directory);
}

VerifiedConfiguration read_rub_configuration(const std::filesystem::path& file) {
  sweep::Study study = config::read_run_config(file, {}).study;
  std::string digest = config::study_digest(study);
  return {std::move(digest), std::move(study)};
}

int verify(const RubsweepArguments& arguments) {
  const std::filesystem::path& directory = *arguments.verified;
  // Only ringstab can read the configuration of a ring.
  if (was_written_by("ringstab", directory)) {
    std::vector<std::string> command{"--verify", directory.string()};
    if (arguments.quiet) command.emplace_back("--quiet");
    become_sibling("ringstab", std::move(command));
  }
  return report_verdict("rubsweep", directory, verify_directory(directory, read_rub_configuration),
                        arguments.quiet);
}

int export_matrices(const RubsweepArguments& arguments, const config::RunConfig& config) {
  const batch::ResultFiles files = config::exported_matrices(config);
  const std::filesystem::path& directory = *arguments.matrices;
  std::error_code none_there;
  if (std::filesystem::equivalent(arguments.config, directory / "rotor.yaml", none_there))
    throw UsageError(
        "--export-matrices: rotor.yaml would replace the configuration that was read, allowed: another DIR");
  const ResultDirectory made(directory, config::exported_matrix_files);
  batch::write_result_files(
      files, config::exported_matrix_files, directory,
      {"rubsweep", config::study_digest(config.study), batch::caption_lines(config.captions)});
  if (!arguments.quiet) print("{}", batch::files_line(files, directory));
  return done;
}

int perform(const RubsweepArguments& arguments) {
  if (arguments.verified) return verify(arguments);
  if (answered("rubsweep", arguments.action, rubsweep_help)) return done;
  if (arguments.key_answer) {
    print("{}", *arguments.key_answer);
    return done;
  }
  if (arguments.motion_kinds) {
    print("{}", motion_kinds_csv());
    return done;
  }
  if (arguments.status) {
    print("{}", map_status(*arguments.status));
    return done;
  }
  if (arguments.watched) {
    watch_map(*arguments.watched);
    return done;
  }
  const config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  ask("rubsweep", config.questions, arguments.quiet);
  if (arguments.matrices) return export_matrices(arguments, config);
  const sweep::Study& study = config.study;
  const int threads = batch::thread_count(arguments.threads);
  StudyActions actions = study_actions("rubsweep", arguments, config, [&] { return run(arguments, config); });
  actions.explanation = [&] {
    return explain_study(study) +
           report::describe_footprint(study, scene::prepare_machine(study.machine), {threads}) + "\n";
  };
  return act(arguments, actions);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubsweep", [&] { return perform(parse_rubsweep_arguments(argc, argv)); });
}
