#include "rubline_arguments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "rubsweep/maps/config/study/sweep.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

constexpr int most_values = 10'000;

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()(
      "along", po::value<std::string>()->value_name("KEY"),
      "what changes along the line: speed_hz, whirl_ratio, eccentricity_m, or any number of the "
      "configuration by the path that --set takes")("from", po::value<double>()->value_name("A"),
                                                    "first value")("to", po::value<double>()->value_name("B"),
                                                                   "last value, > A")(
      "count", po::value<int>()->value_name("N"),
      "how many evenly spaced values (101); without --from and --to those of the sweep's axis");
  add_place(options);
  options.add_options()("kick", "every cell from its kick, as in a map (the default)")(
      "up", "upward, each cell from what the one before it does")("down", "downward, likewise");
  add_figure(options, "draw the bifurcation diagram as FILE.png, .svg or .pdf");
  options.add_options()("cascade-figure", po::value<std::string>()->value_name("FILE"),
                        "draw the cascade of full spectra as FILE.png, .svg or .pdf");
  add_output(options, "write there instead of output.directory + _line");
  add_threads(options, "threads; 0: one per processor");
  add_set(options);
  add_progress(options);
  add_last(options);
  return options;
}

std::optional<LineValues> values_of(const po::variables_map& given) {
  const bool from = given.count("from") != 0, to = given.count("to") != 0;
  if (from != to) throw UsageError("--from and --to belong together");
  if (!from) {
    if (given.count("count") != 0) throw UsageError("--count belongs to --from and --to");
    return std::nullopt;
  }
  LineValues values{.from = given["from"].as<double>(), .to = given["to"].as<double>()};
  if (given.count("count") != 0) values.count = given["count"].as<int>();
  if (!std::isfinite(values.from) || !std::isfinite(values.to) || values.to <= values.from)
    throw UsageError("--to: allowed: a number > --from");
  if (values.count < 2 || values.count > most_values)
    throw UsageError(fmt::format("--count: allowed: a number from 2 to {}", most_values));
  return values;
}

/// Throws where the quantity along the line also has a fixed value.
void refuse_place_along(const RublineArguments& arguments) {
  for (const std::string_view key :
       {config::study::speed_rpm_key, config::study::unbalance_key, config::study::grade_key}) {
    if (arguments.along == key)
      throw UsageError(fmt::format("--along {}: a line runs along SI units, allowed: --along {}", key,
                                   key == config::study::speed_rpm_key ? "speed_hz" : "eccentricity_m"));
  }
  const bool along_unbalance = arguments.along == "whirl_ratio" || arguments.along == "eccentricity_m";
  if (arguments.along == "speed_hz" && arguments.place.speed_hz)
    throw UsageError("--speed-hz, --speed-rpm: the line runs along the speed, allowed: another --along");
  if (along_unbalance && arguments.place.has_unbalance())
    throw UsageError(
        "--whirl-ratio, --eccentricity-m, --unbalance-g-mm: the line runs along the unbalance, allowed: "
        "another "
        "--along");
}

}  // namespace

RublineArguments parse_rubline_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  RublineArguments arguments{study_arguments(given, "rubline")};
  if (arguments.action != Action::run) return arguments;
  if (given.count("along") == 0) throw UsageError("what changes along the line is needed: --along KEY");
  arguments.along = given["along"].as<std::string>();
  arguments.values = values_of(given);
  arguments.place = read_place(given);
  refuse_place_along(arguments);
  for (const line::Pass pass : {line::Pass::kick, line::Pass::up, line::Pass::down})
    if (given.count(std::string(to_string(pass))) != 0) arguments.passes.push_back(pass);
  if (arguments.passes.empty()) arguments.passes = {line::Pass::kick};
  arguments.figure = figure_of(given);
  arguments.cascade_figure = figure_of(given, "cascade-figure");
  arguments.threads = threads_of(given);
  arguments.progress = progress_of(given);
  return arguments;
}

std::string rubline_help() {
  return fmt::format(
      "rubline CONFIG.yaml --along KEY [options]\n"
      "What the rotor does along a line: section points for a bifurcation diagram, full spectra for a "
      "cascade.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubline configs/benchmark/one_side.yaml --along speed_hz --whirl-ratio 0.4 --figure "
      "bifurcation.png\n"
      "  rubline configs/benchmark/one_side.yaml --along speed_hz --from 50 --to 150 --whirl-ratio 0.4 --up "
      "--down\n"
      "  rubline configs/minimal.yaml --along stops.0.clearance_m --from 5e-4 --to 2e-3 --speed-hz 75 "
      "--eccentricity-m 2e-4\n\n"
      "The place of the line must be said where the sweep of the configuration has several values for it.\n"
      "Upward and downward a cell starts on the settled motion of the one before it, without a kick; the "
      "first one\n"
      "and one behind a cell without motion start from their kick. The column `start` says so: handed_on.\n\n"
      "Writes into DIR, rows by pass and then by value:\n"
      "  line.csv         pass, value of KEY (in the unit of its name), and the columns of map.csv\n"
      "  bifurcation.csv  the state of the rotor once per revolution, at the phase of smallest quiet gap: as "
      "many "
      "points\n"
      "                   as a period has turns, two windows of any other motion; x_m, y_m, vx_m_per_s, "
      "vy_m_per_s\n"
      "  cascade.csv      lines of the full spectrum up to order 8 (negative: backward) above a thousandth "
      "of the "
      "largest:\n"
      "                   order, frequency_hz, amplitude_m\n"
      "  config.yaml      the complete configuration\n"
      "Interrupted, it writes the cells that are finished.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 done, but some cells failed; 70 "
      "out of "
      "memory\n"
      "or a fault of the program; 128+signal when interrupted.\n",
      text_of(visible_options()));
}

}  // namespace rubsweep::apps
