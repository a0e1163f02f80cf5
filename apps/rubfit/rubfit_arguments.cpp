#include "rubfit_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

po::options_description visible_options() {
  po::options_description options("Options");
  const auto files = [] { return po::value<Texts>()->value_name("FILE.csv"); };
  options.add_options()(
      "fit", po::value<Texts>()->value_name("KEY[=LOW:HIGH]"),
      "a number to be found, again for each: a key as --set names it, or eccentricity_m, mark_deg, "
      "hit_s, rate_hz_per_s; LOW:START:HIGH also says where to begin")(
      "ring-down", files(), "readings after an impulse: t_s, sensor_0_m, ...")(
      "run-up", files(), "1X on a ramp, bode.csv of rubscope")(
      "steady", files(), "1X at steady speeds: speed_hz, sensor_0_amplitude_m, sensor_0_phase_deg, ...")(
      "ramp", files(), "the same columns on a ramp of --rate-hz-per-s")(
      "rub", po::value<Texts>()->value_name("DIR"),
      "lines of a rub at a steady speed, a directory of rubscope; what the kick of the configuration leads "
      "to")("rate-hz-per-s", po::value<double>()->value_name("R"), "of --ramp, below 0 for a coast-down")(
      "window-turns", po::value<double>()->value_name("N"),
      "turns that each 1X of --ramp is the mean of; 0 unless given")(
      "eccentricity-m", po::value<double>()->value_name("E"),
      "of the unbalance, where it is not to be found")("mark-deg", po::value<double>()->value_name("A"),
                                                       "angle between both marks, likewise; 0 unless given")(
      "hit-s", po::value<double>()->value_name("T"), "instant of the impulse, likewise; 0 unless given")(
      "from-s", po::value<double>()->value_name("T"), "leave out what ring-downs read before")(
      "phase", po::value<std::string>()->value_name("lag|mark|sensor"),
      "what phases of --steady and --ramp are. lag: degrees by which the positive peak of the vibration lags "
      "behind the once-per-turn mark, 0 to 360, as instruments say; mark: the same with a minus, as in "
      "bode.csv of rubscope; sensor: as mark, but from the instant at which the mark passes each sensor, as "
      "in bode.csv of rubtrace. Unless given sensor, or what leaves less than half where sensor leaves more "
      "than a tenth, which is said")("run-out",
                                     "every sensor's 1X has a constant of its own beside the vibration")(
      "starts", po::value<int>()->value_name("N"),
      "begin at so many places between the bounds; 1 unless given")(
      "robust", po::value<double>()->value_name("K"), "outliers beyond K standard deviations count less")(
      "compare-without", po::value<Texts>()->value_name("KEY,KEY,..."),
      "fit once more with these left as the configuration has them, and say which the data want");
  add_set(options);
  add_output(options, "write there instead of into the configuration's output directory with _fit");
  add_figure(options, "draw data and model, and the numbers that were found");
  add_last(options);
  return options;
}

double number_in(std::string_view text, const std::string& whole) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw UsageError(
        fmt::format("--fit {}: allowed: KEY, KEY=LOW:HIGH or KEY=LOW:START:HIGH with numbers", whole));
  return value;
}

FittedKey key_in(const std::string& text) {
  const std::size_t equals = text.find('=');
  FittedKey key{.name = text.substr(0, equals)};
  if (equals == std::string::npos) return key;
  std::vector<double> numbers;
  for (const std::string_view part : parts_of(std::string_view(text).substr(equals + 1), ':'))
    numbers.push_back(number_in(part, text));
  if (numbers.size() < 2 || numbers.size() > 3 || !std::ranges::is_sorted(numbers) ||
      numbers.front() == numbers.back())
    throw UsageError(fmt::format("--fit {}: allowed: bounds that rise, LOW:HIGH or LOW:START:HIGH", text));
  key.low = numbers.front();
  key.high = numbers.back();
  if (numbers.size() == 3) key.start = numbers[1];
  return key;
}

std::vector<fs::path> files_of(const po::variables_map& given, const char* name) {
  if (!given.count(name)) return {};
  const auto& names = given[name].as<Texts>();
  return {names.begin(), names.end()};
}

double number_of(const po::variables_map& given, const char* name) {
  if (!given.count(name)) return 0;
  const double value = given[name].as<double>();
  if (!std::isfinite(value)) throw UsageError(fmt::format("--{}: allowed: a finite number", name));
  return value;
}

std::optional<fit::PhaseConvention> phases_of(const po::variables_map& given) {
  if (!given.count("phase")) return std::nullopt;
  const auto& text = given["phase"].as<std::string>();
  for (const auto convention :
       {fit::PhaseConvention::lag, fit::PhaseConvention::mark, fit::PhaseConvention::sensor})
    if (text == name_of(convention)) return convention;
  throw UsageError(fmt::format("--phase {}: allowed: lag, mark, sensor", text));
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  while (true) {
    names.emplace_back(text.substr(0, text.find(',')));
    if (names.back().size() == text.size()) return names;
    text.remove_prefix(names.back().size() + 1);
  }
}

}  // namespace

const char* name_of(fit::PhaseConvention convention) {
  return convention == fit::PhaseConvention::lag    ? "lag"
         : convention == fit::PhaseConvention::mark ? "mark"
                                                    : "sensor";
}

std::string rubfit_help() {
  return fmt::format(
      "rubfit CONFIG.yaml --fit KEY ... --ring-down|--run-up|--steady|--ramp FILE.csv|--rub DIR ... "
      "[options]\n"
      "Finds numbers of a machine from what was measured: least squares of ring-downs, of 1X at steady "
      "speeds and of 1X on ramps, by the response to the ramp itself, without stops; and of the lines of a "
      "rub.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubfit kit.yaml --ring-down hit/sensors.csv --fit rotor.damping_ratio --fit hit_s=-0.01:0.01\n"
      "  rubfit kit.yaml --run-up run7_scope/bode.csv --fit rotor.supports.0.stiffness_x_n_per_m\n"
      "      --fit rotor.damping_ratio --fit eccentricity_m=1e-6:1e-4 --fit mark_deg=-180:180\n"
      "      --figure run7_fit.png\n\n"
      "Writes into DIR:\n"
      "  config.yaml      the configuration with what was found\n"
      "  parameters.csv   values with standard errors and 95 % intervals\n"
      "  correlation.csv  of the parameters\n"
      "  fitted.csv       data and model\n\n"
      "Ctrl-C writes the best that was found so far.\n\n"
      "Exit codes: 0 done; 1 usage; 2 a configuration or data that cannot be used; 3 input/output; 4 no "
      "fit.\n",
      text_of(visible_options()));
}

RubfitArguments parse_rubfit_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  RubfitArguments arguments;
  static_cast<StudyArguments&>(arguments) = study_arguments(given, "rubfit");
  if (arguments.action != Action::run) return arguments;
  if (!given.count("fit")) throw UsageError("--fit: a number to be found is needed");
  for (const std::string& text : given["fit"].as<Texts>()) {
    arguments.keys.push_back(key_in(text));
    const auto same = [&](const FittedKey& key) { return key.name == arguments.keys.back().name; };
    if (std::ranges::count_if(arguments.keys, same) > 1)
      throw UsageError(fmt::format("--fit {}: is given twice", text));
  }
  arguments.ring_downs = files_of(given, "ring-down");
  arguments.run_ups = files_of(given, "run-up");
  arguments.steady = files_of(given, "steady");
  arguments.ramped_speeds = files_of(given, "ramp");
  arguments.rubs = files_of(given, "rub");
  if (arguments.ring_downs.empty() && arguments.run_ups.empty() && arguments.steady.empty() &&
      arguments.ramped_speeds.empty() && arguments.rubs.empty())
    throw UsageError("data are needed: --ring-down, --run-up, --steady, --ramp or --rub");
  if (given.count("rate-hz-per-s")) arguments.rate_hz_per_s = number_of(given, "rate-hz-per-s");
  if (arguments.ramped_speeds.empty() == arguments.rate_hz_per_s.has_value() || arguments.rate_hz_per_s == 0)
    throw UsageError("--ramp and --rate-hz-per-s go together; allowed: a rate other than 0");
  arguments.window_turns = not_negative_number(given, "window-turns").value_or(0);
  arguments.eccentricity_m = not_negative_number(given, "eccentricity-m").value_or(0);
  arguments.mark_deg = number_of(given, "mark-deg");
  arguments.hit_s = number_of(given, "hit-s");
  arguments.from_s = given.count("from-s") ? number_of(given, "from-s") : -INFINITY;
  arguments.phases = phases_of(given);
  if (arguments.phases && arguments.steady.empty() && arguments.ramped_speeds.empty())
    throw UsageError("--phase: is of tables, allowed: with --steady or --ramp");
  arguments.run_out = given.count("run-out") > 0;
  if (given.count("starts")) arguments.starts = given["starts"].as<int>();
  if (arguments.starts < 1 || arguments.starts > 100) throw UsageError("--starts: allowed: 1 to 100");
  arguments.robust_beyond = positive_number(given, "robust").value_or(0);
  arguments.figure = figure_of(given);
  if (given.count("compare-without")) {
    for (const std::string& text : given["compare-without"].as<Texts>())
      for (std::string& name : names_in(text)) arguments.without.push_back(std::move(name));
    for (const std::string& name : arguments.without) {
      if (std::ranges::find(arguments.keys, name, &FittedKey::name) == arguments.keys.end())
        throw UsageError(fmt::format("--compare-without {}: allowed: names that --fit has", name));
    }
    if (arguments.without.size() >= arguments.keys.size())
      throw UsageError("--compare-without: allowed: fewer names than --fit has");
  }
  return arguments;
}

}  // namespace rubsweep::apps
