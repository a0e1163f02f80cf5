#include "rubtrace_arguments.hpp"

#include <fmt/format.h>

#include <boost/program_options.hpp>
#include <cmath>
#include <sstream>

#include "program.hpp"

namespace rubsweep::apps {
namespace {

namespace po = boost::program_options;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()("speed-hz", po::value<double>()->value_name("S"), "shaft speed")(
      "whirl-ratio", po::value<double>()->value_name("U"),
      "unbalance, said by the quiet motion: its largest excursion / remaining clearance at the first stop")(
      "eccentricity-m", po::value<double>()->value_name("E"),
      "unbalance, said by the eccentricity of the disc")(
      "revolutions", po::value<long>()->value_name("N"),
      "revolutions to run from the start of the kick, never fewer; default: response.max_revolutions")(
      "last-revolutions", po::value<long>()->value_name("M"),
      "only the last M revolutions go into trajectory.csv; default: all")(
      "output", po::value<std::string>()->value_name("DIR"),
      "write there instead of output.directory + _trace")(
      "set", po::value<std::vector<std::string>>()->value_name("KEY.PATH=VALUE")->composing(),
      "replace one value of the configuration; lists are indexed by number; may be repeated")(
      "quiet", "print errors only")("help", "print this and exit")("version", "print the version and exit");
  return options;
}

/// A number of the command line that must satisfy `allowed`, said in words as `range`.
template <class Number, class Allowed>
std::optional<Number> read(const po::variables_map& given, const char* name, const char* range,
                           Allowed allowed) {
  if (given.count(name) == 0) return std::nullopt;
  const Number value = given[name].as<Number>();
  if (!allowed(value)) throw UsageError(fmt::format("--{}: allowed: {}", name, range));
  return value;
}

bool not_negative(double value) { return std::isfinite(value) && value >= 0; }
bool at_least_one(long value) { return value >= 1; }

scene::Unbalance unbalance_of(const po::variables_map& given) {
  const auto ratio = read<double>(given, "whirl-ratio", "a number >= 0", not_negative);
  const auto eccentricity_m = read<double>(given, "eccentricity-m", "a number >= 0", not_negative);
  if (ratio.has_value() == eccentricity_m.has_value()) {
    throw UsageError("the unbalance is needed, one way: --whirl-ratio U or --eccentricity-m E");
  }
  if (ratio) return scene::WhirlRatio{*ratio};
  return scene::Eccentricity{*eccentricity_m};
}

}  // namespace

RubtraceArguments parse_rubtrace_arguments(int argc, const char* const* argv) {
  po::options_description all = visible_options();
  all.add_options()("config", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("config", 1);
  po::variables_map given;
  try {
    // No guessing: --revolution is an error, not --revolutions.
    const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
              given);
  } catch (const po::error& error) {
    throw UsageError(error.what());
  }
  RubtraceArguments arguments;
  arguments.version = given.count("version") != 0;
  arguments.help = given.count("help") != 0;
  if (arguments.help || arguments.version) return arguments;
  if (given.count("config") == 0) throw UsageError("a configuration file is needed: rubtrace CONFIG.yaml");
  arguments.config = given["config"].as<std::string>();
  const auto speed_hz = read<double>(given, "speed-hz", "a number > 0",
                                     [](double value) { return not_negative(value) && value > 0; });
  if (!speed_hz) throw UsageError("the shaft speed is needed: --speed-hz S");
  arguments.speed_hz = *speed_hz;
  arguments.unbalance = unbalance_of(given);
  arguments.revolutions = read<long>(given, "revolutions", "a number >= 1", at_least_one);
  arguments.last_revolutions = read<long>(given, "last-revolutions", "a number >= 1", at_least_one);
  if (given.count("output") != 0) {
    arguments.output = given["output"].as<std::string>();
    if (arguments.output->empty()) throw UsageError("--output: allowed: the name of a directory");
  }
  if (given.count("set") != 0) arguments.overrides = given["set"].as<std::vector<std::string>>();
  arguments.quiet = given.count("quiet") != 0;
  return arguments;
}

std::string rubtrace_help() {
  std::ostringstream options;
  options << visible_options();
  return fmt::format(
      "rubtrace CONFIG.yaml --speed-hz S (--whirl-ratio U | --eccentricity-m E) [options]\n"
      "One cell of a map under the lens: the motion from the start of the kick, all its revolutions.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubtrace configs/figure06_one_side.yaml --speed-hz 75 --whirl-ratio 0.3\n"
      "  rubtrace configs/minimal.yaml --speed-hz 54 --eccentricity-m 3e-4 --revolutions 100 --output "
      "/tmp/trace\n"
      "  scripts/trace.sh /tmp/trace /tmp/picture 'A trace'      (draws it)\n\n"
      "Writes into DIR, stops counted from 0, times from the start of the kick:\n"
      "  trajectory.csv  displacement and velocity of the rotor; casing, gap and forces of every stop "
      "(forces on\n"
      "                  the casing); N revolutions of response.samples_per_revolution samples\n"
      "  section.csv     the state once per revolution, at the phase of smallest quiet gap, from revolution "
      "0\n"
      "  events.csv      changes of contact mode: open, clamped, sprung, released; none with contact: "
      "smoothed\n"
      "  spectrum.csv    full spectrum of the last whole periods in response.window_revolutions revolutions\n"
      "  motion.csv      the row that a map holds of this cell, with its own number of revolutions\n"
      "  config.yaml     the complete configuration, its sweep reduced to this cell\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 the run failed, the files end at "
      "the\n"
      "failure, or there was nothing to run (motion.csv and config.yaml only). An interrupted run writes "
      "nothing.\n",
      options.str());
}

}  // namespace rubsweep::apps
