#include "ringstab_arguments.hpp"

#include <fmt/format.h>

#include <boost/program_options.hpp>
#include <sstream>

#include "program.hpp"

namespace rubsweep::apps {
namespace {

namespace po = boost::program_options;

constexpr int most_threads = 1024;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()("output", po::value<std::string>()->value_name("DIR"),
                        "write there instead of output.directory")(
      "threads", po::value<int>()->value_name("N")->default_value(0),
      "threads of a chart; 0: one per processor")(
      "set", po::value<std::vector<std::string>>()->value_name("KEY.PATH=VALUE")->composing(),
      "replace one value of the configuration; lists are indexed by number; may be repeated")(
      "check", "read the configuration, report every problem, run nothing")(
      "explain", "say what is modelled and how it is solved, run nothing")(
      "print-config", "print the complete configuration with every default, run nothing")(
      "progress", po::value<std::string>()->value_name("WHEN")->default_value("auto"),
      "auto (only on a terminal), always or never")("quiet", "print errors only")(
      "help", "print this and exit")("version", "print the version and exit");
  return options;
}

RingstabAction action_of(const po::variables_map& given) {
  RingstabAction action = RingstabAction::run;
  int count = 0;
  const auto choose = [&](const char* name, RingstabAction chosen) {
    if (given.count(name) == 0) return;
    action = chosen;
    ++count;
  };
  choose("check", RingstabAction::check);
  choose("explain", RingstabAction::explain);
  choose("print-config", RingstabAction::print_config);
  if (count > 1) throw UsageError("--check, --explain and --print-config exclude each other");
  if (given.count("version") != 0) return RingstabAction::version;
  if (given.count("help") != 0) return RingstabAction::help;
  return action;
}

batch::ProgressMode progress_of(const std::string& word) {
  if (word == "auto") return batch::ProgressMode::automatic;
  if (word == "always") return batch::ProgressMode::always;
  if (word == "never") return batch::ProgressMode::never;
  throw UsageError(fmt::format("--progress: '{}' is not allowed, allowed: auto, always, never", word));
}

po::variables_map parse(int argc, const char* const* argv) {
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
  return given;
}

}  // namespace

RingstabArguments parse_ringstab_arguments(int argc, const char* const* argv) {
  const po::variables_map given = parse(argc, argv);
  RingstabArguments arguments;
  arguments.action = action_of(given);
  if (arguments.action == RingstabAction::help || arguments.action == RingstabAction::version)
    return arguments;
  if (given.count("config") == 0) throw UsageError("a configuration file is needed: ringstab CONFIG.yaml");
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
  return arguments;
}

std::string ringstab_help() {
  std::ostringstream options;
  options << visible_options();
  return fmt::format(
      "ringstab CONFIG.yaml [options]\n"
      "Stability of rotating loads that rub on an elastic ring: eigenvalues over the speed, onsets, critical "
      "speeds.\n\n"
      "{}\n"
      "Examples:\n"
      "  ringstab configs/ring_figure10.yaml\n"
      "  ringstab configs/ring_figure10.yaml --set friction_coefficient=0 --output /tmp/smooth\n"
      "  ringstab configs/ring_figure10.yaml --set loads.0.inclination_deg=5 --quiet\n"
      "  ringstab configs/ring_figure15_n2.yaml --threads 2      (a stability chart)\n\n"
      "Writes into DIR; speeds in revolutions per minute, loads counted from 0:\n"
      "  eigenvalues.csv      every mode over the speed: real part (positive: unstable) and frequency\n"
      "  onsets.csv           divergence, flutter, coupling, veering and stable windows, with the modes "
      "concerned\n"
      "  critical_speeds.csv  speeds known in closed form beside those found numerically\n"
      "  static_load.csv      with ring.radius_m: steady normal force and slip of every load, where the "
      "model is valid\n"
      "  chart.csv, chart_onsets.csv   with chart: the same over a second parameter\n"
      "  config.yaml          the complete configuration\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 done, but some lines of the chart "
      "failed;\n"
      "128+signal when interrupted: finished lines stay in chart.partial.csv.\n",
      options.str());
}

}  // namespace rubsweep::apps
