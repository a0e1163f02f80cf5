#include "rubsweep_arguments.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <string_view>
#include <vector>

#include "keys/key_questions.hpp"
#include "map_options.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/templates.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"
#include "shared/table_columns.hpp"

namespace rubsweep::apps {
namespace {

/// Largest number of shards; each leaves a journal that a merge has to open.
constexpr std::size_t most_shards = 10000;

po::options_description visible_options() {
  po::options_description options("Options");
  add_map_files(options);
  add_threads(options, "threads; 0: one per processor");
  add_set(options);
  options.add_options()(
      "init", po::value<std::string>()->value_name("KIND"),
      "instead: print a commented configuration to begin with: one_side, both_sides, annular, "
      "rotor_kit or ross")("motion-kinds",
                           "instead: print the kinds of motion, their colours and signs, as CSV")(
      "columns", "instead: print the columns of the tables of all programs, and the words in them, as CSV")(
      "status", po::value<std::string>()->value_name("DIR"),
      "instead: say how far the map in DIR is, of which shards, and who is at work")(
      "watch", po::value<std::string>()->value_name("DIR"),
      "instead: show the map in DIR while it is computed, and what each process does, until nobody is at "
      "work")("export-matrices", po::value<std::string>()->value_name("DIR"),
              "instead: write the rotor kit as matrices of all its elements into DIR, with a configuration "
              "that reads them");
  add_fresh(options);
  options.add_options()(
      "shard", po::value<std::string>()->value_name("I/N"),
      "compute the I-th of N parts of the map alone; others may run at the same time, on any machine")(
      "merge", "run nothing, put the finished shards of a map together");
  add_verify(
      options,
      "run nothing, say whether the results in a directory, of any program, are whole and belong together");
  add_report(options);
  add_key_questions(options);
  add_actions(options, "say what is simulated, what is left out and why, run nothing");
  add_progress(options);
  add_last(options);
  return options;
}

/// Reads a shard such as "2/8"; both numbers count from 1.
map::Share shard_of(const std::string& text) {
  map::Share share;
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, share.index);
  if (index.ec == std::errc() && index.ptr != end && *index.ptr == '/') {
    const auto count = std::from_chars(index.ptr + 1, end, share.count);
    const bool good = count.ec == std::errc() && count.ptr == end && share.count <= most_shards;
    if (good && share.index >= 1 && share.index-- <= share.count) return share;
  }
  throw UsageError(
      fmt::format("--shard: '{}' is not allowed, allowed: I/N with 1 <= I <= N <= {}", text, most_shards));
}

std::string begun_configuration(const std::string& kind) {
  if (auto text = templates::template_text(kind)) return *std::move(text);
  const std::vector<std::string_view> names = templates::template_names();
  throw UsageError(fmt::format("--init: {}, allowed: {}", config::yaml::describe_unknown(kind, names),
                               fmt::join(names, ", ")));
}

void read_division(const po::variables_map& given, RubsweepArguments& arguments) {
  arguments.fresh = given.count("fresh") != 0;
  arguments.merge = given.count("merge") != 0;
  if (given.count("shard") != 0) arguments.shard = shard_of(given["shard"].as<std::string>());
  if (arguments.merge && (arguments.fresh || arguments.shard)) {
    throw UsageError("--merge excludes --fresh and --shard");
  }
  arguments.report = given.count("report") != 0;
  if (arguments.report && arguments.shard)
    throw UsageError("--report needs the whole map: give it to --merge instead of --shard");
  if (given.count("figure") != 0 && arguments.shard)
    throw UsageError("--figure needs the whole map: give it to --merge instead of --shard");
  arguments.fade = given.count("fade") != 0;
  if (arguments.fade && given.count("figure") == 0) throw UsageError("--fade belongs to --figure");
  if (arguments.action == Action::run) arguments.figure = figure_of(given);
}

}  // namespace

RubsweepArguments parse_rubsweep_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  if (auto directory = verified_directory_of(given)) {
    RubsweepArguments verification;
    verification.verified = std::move(directory);
    verification.quiet = given.count("quiet") != 0;
    return verification;
  }
  if (asks_for("status", given)) {
    RubsweepArguments status;
    status.status = given["status"].as<std::string>();
    return status;
  }
  if (asks_for("watch", given)) {
    RubsweepArguments watch;
    watch.watched = given["watch"].as<std::string>();
    return watch;
  }
  if (auto answer = key_answer(given, config::run_form, "Configuration of rubsweep")) {
    RubsweepArguments question;
    question.key_answer = std::move(answer);
    return question;
  }
  if (asks_for("init", given)) {
    RubsweepArguments beginning;
    beginning.key_answer = begun_configuration(given["init"].as<std::string>());
    return beginning;
  }
  if (asks_for("columns", given)) {
    RubsweepArguments columns;
    columns.key_answer = table_columns;
    return columns;
  }
  if (asks_for("motion-kinds", given)) {
    RubsweepArguments kinds;
    kinds.motion_kinds = true;
    return kinds;
  }
  RubsweepArguments arguments{study_arguments(given, "rubsweep")};
  if (arguments.action == Action::help || arguments.action == Action::version) return arguments;
  arguments.threads = threads_of(given);
  arguments.progress = progress_of(given);
  read_division(given, arguments);
  if (given.count("export-matrices") != 0) {
    if (arguments.action != Action::run || arguments.merge || arguments.shard || arguments.report ||
        arguments.figure)
      throw UsageError(
          "--export-matrices runs nothing: it excludes every other question, --shard and pictures");
    arguments.matrices = given["export-matrices"].as<std::string>();
  }
  return arguments;
}

std::string rubsweep_help() {
  return fmt::format(
      "rubsweep CONFIG.yaml [options]\n"
      "Maps where rub persists over speed and unbalance, and which motion it becomes.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubsweep configs/benchmark/one_side.yaml\n"
      "  rubsweep configs/minimal.yaml --output /tmp/map --threads 1\n"
      "  rubsweep configs/benchmark/one_side.yaml --set stops.0.friction.coefficient=0.2 --output /tmp/mu02\n"
      "  rubsweep configs/benchmark/one_side.yaml --explain\n"
      "  rubsweep configs/benchmark/kick_and_restitution.yaml\n"
      "  rubsweep configs/benchmark/threshold_one_side.yaml\n"
      "  rubsweep configs/minimal.yaml --set 'study={{kind: basin, samples: 200, over: [{{key: kick.force_n, "
      "from: 0, to: 400}}]}}'\n"
      "  rubsweep configs/benchmark/one_side.yaml --set 'sweep.refine={{levels: 2, probes: 1}}' --output "
      "/tmp/refined\n"
      "  rubsweep configs/benchmark/one_side.yaml --shard 2/8\n"
      "  rubsweep --status results/benchmark/one_side\n"
      "  rubsweep --watch results/benchmark/one_side\n"
      "  rubsweep configs/benchmark/one_side.yaml --report\n"
      "  rubsweep configs/benchmark/one_side.yaml --figure map.png\n"
      "  rubsweep --init one_side > my.yaml\n"
      "  rubsweep --keys stops.0.friction\n"
      "  rubsweep --verify results/benchmark/one_side\n"
      "  rubsweep configs/rotor_kit.yaml --export-matrices /tmp/matrices\n\n"
      "On a terminal the map is also shown in characters, with commands that look closer.\n\n"
      "Writes into DIR:\n"
      "  map.csv          one row per cell, speed fastest; only ever whole\n"
      "  config.yaml      the complete configuration, with every default\n"
      "  painted.csv      with sweep.refine: every cell of the finest lattice\n"
      "  report.html      with --report: a page that shows the map and the motion of each cell\n"
      "  map.partial.csv  finished cells while the sweep runs, to look at\n"
      "  map.journal      finished cells of a run that is not over, to go on from\n"
      "  map.lock, map.begin.lock   who is at work, and who is about to begin\n"
      "  map.shard-I-of-N.*, map.rank-R.*   the same of a shard or of a process of rubsweep-mpi\n"
      "However a run ends before the map is whole, the same command computes the other cells. A finished map "
      "stays: one of another configuration is refused, one of the same is all there is to do, unless --fresh "
      "is given.\n\n"
      "A half-sine kick (kick.force_n, kick.duration_s) starts each cell, towards the wall of the first stop "
      "unless kick.angle_deg\n"
      "(from +x towards +y) says otherwise. From a whirl ratio of 1, where the quiet whirl itself reaches "
      "the wall, the rotor starts\n"
      "at rest and is not kicked; the column `start` says so.\n\n"
      "{}\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration, or DIR holds cells or a map of another one; 3 "
      "input/output;\n"
      "4 done, but some cells failed; 6 another process is at work in DIR; 7 --verify: not whole; 70 out of "
      "memory or a fault of "
      "the "
      "program;\n"
      "75 a shard of a refined map did what it could, and others must go on; 128+signal when interrupted.\n",
      text_of(visible_options()), report::describe_map_columns());
}

}  // namespace rubsweep::apps
