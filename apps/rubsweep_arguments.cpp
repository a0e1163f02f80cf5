#include "rubsweep_arguments.hpp"

#include <fmt/format.h>

#include <boost/program_options.hpp>
#include <charconv>
#include <sstream>

#include "program.hpp"

namespace rubsweep::apps {
namespace {

namespace po = boost::program_options;

/// More would only exhaust the system: cells share nothing, a thread per processor is all that helps.
constexpr int most_threads = 1024;

/// Each leaves a journal that the merge opens.
constexpr std::size_t most_shards = 10000;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()("output", po::value<std::string>()->value_name("DIR"),
                        "write there instead of output.directory")(
      "threads", po::value<int>()->value_name("N")->default_value(0), "threads; 0: one per processor")(
      "set", po::value<std::vector<std::string>>()->value_name("KEY.PATH=VALUE")->composing(),
      "replace one value of the configuration; lists are indexed by number; may be repeated")(
      "fresh", "forget what an interrupted run finished and start over")(
      "shard", po::value<std::string>()->value_name("I/N"),
      "compute the I-th of N parts of the map alone; others may run at the same time, on any machine")(
      "merge", "run nothing, put the finished shards of a map together")(
      "check", "read the configuration, report every problem, run nothing")(
      "explain", "say what is simulated, what is left out and why, run nothing")(
      "print-config", "print the complete configuration with every default, run nothing")(
      "progress", po::value<std::string>()->value_name("WHEN")->default_value("auto"),
      "auto (only on a terminal), always or never")("quiet", "print errors only")(
      "help", "print this and exit")("version", "print the version and exit");
  return options;
}

Action action_of(const po::variables_map& given) {
  Action action = Action::run;
  int count = 0;
  const auto choose = [&](const char* name, Action chosen) {
    if (given.count(name) == 0) return;
    action = chosen;
    ++count;
  };
  choose("check", Action::check);
  choose("explain", Action::explain);
  choose("print-config", Action::print_config);
  if (count > 1) throw UsageError("--check, --explain and --print-config exclude each other");
  if (given.count("version") != 0) return Action::version;
  if (given.count("help") != 0) return Action::help;
  return action;
}

batch::ProgressMode progress_of(const std::string& word) {
  if (word == "auto") return batch::ProgressMode::automatic;
  if (word == "always") return batch::ProgressMode::always;
  if (word == "never") return batch::ProgressMode::never;
  throw UsageError(fmt::format("--progress: '{}' is not allowed, allowed: auto, always, never", word));
}

/// "2/8", both numbers from 1.
Share shard_of(const std::string& text) {
  Share share;
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

void read_division(const po::variables_map& given, RubsweepArguments& arguments) {
  arguments.fresh = given.count("fresh") != 0;
  arguments.merge = given.count("merge") != 0;
  if (given.count("shard") != 0) arguments.shard = shard_of(given["shard"].as<std::string>());
  if (arguments.merge && (arguments.fresh || arguments.shard)) {
    throw UsageError("--merge excludes --fresh and --shard");
  }
}

}  // namespace

RubsweepArguments parse_rubsweep_arguments(int argc, const char* const* argv) {
  po::options_description all = visible_options();
  all.add_options()("config", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("config", 1);
  po::variables_map given;
  try {
    // No guessing: --thread is an error, not --threads.
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  RubsweepArguments arguments;
  arguments.action = action_of(given);
  if (arguments.action == Action::help || arguments.action == Action::version) return arguments;
  if (given.count("config") == 0) throw UsageError("a configuration file is needed: rubsweep CONFIG.yaml");
  arguments.config = given["config"].as<std::string>();
  if (given.count("output") != 0) {
    arguments.output = given["output"].as<std::string>();
    if (arguments.output->empty()) throw UsageError("--output: allowed: the name of a directory");
  }
  if (given.count("set") != 0) arguments.overrides = given["set"].as<std::vector<std::string>>();
  arguments.threads = given["threads"].as<int>();
  if (arguments.threads < 0 || arguments.threads > most_threads) {
    throw UsageError(fmt::format("--threads: allowed: a number from 0 to {}", most_threads));
  }
  arguments.progress = progress_of(given["progress"].as<std::string>());
  arguments.quiet = given.count("quiet") != 0;
  read_division(given, arguments);
  return arguments;
}

std::string rubsweep_help() {
  std::ostringstream options;
  options << visible_options();
  return fmt::format(
      "rubsweep CONFIG.yaml [options]\n"
      "Maps where rub persists over speed and unbalance, and which motion it becomes.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubsweep configs/figure06_one_side.yaml\n"
      "  rubsweep configs/minimal.yaml --output /tmp/map --threads 1\n"
      "  rubsweep configs/figure06_one_side.yaml --set stops.0.friction.coefficient=0.2 --output /tmp/mu02\n"
      "  rubsweep configs/figure06_one_side.yaml --explain\n"
      "  rubsweep configs/figure06_one_side.yaml --shard 2/8\n\n"
      "Writes DIR/map.csv (one row per cell, speed fastest) and DIR/config.yaml (the complete "
      "configuration);\n"
      "finished cells can be watched in DIR/map.partial.csv while the sweep runs. However a run ends before "
      "the map\n"
      "is whole, DIR/map.journal keeps every finished cell and the same command computes the others.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration, or DIR holds cells of another one; 3 input/output; "
      "4 done,\n"
      "but some cells failed; 6 another process is at work in DIR; 128+signal when interrupted.\n",
      options.str());
}

}  // namespace rubsweep::apps
