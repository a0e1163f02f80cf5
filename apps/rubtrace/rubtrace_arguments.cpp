#include "rubtrace_arguments.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/analysis/linear/experiment.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubtrace_options.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"
#include "shared/shown_lengths.hpp"
#include "speed_ranges.hpp"

namespace rubsweep::apps {
namespace {

constexpr long most_kick_speeds = 1000;
constexpr double most_gas_density = 1e4;  // in kg/m3

std::optional<long> count_of(const po::variables_map& given, const char* name) {
  if (given.count(name) == 0) return std::nullopt;
  const long value = given[name].as<long>();
  if (value < 1) throw UsageError(fmt::format("--{}: allowed: a number >= 1", name));
  return value;
}

/// Whether a trace includes readings of sensors or probes.
bool asks_for_probes(const po::variables_map& given) {
  return !given["sample-s"].defaulted() || !given["noise-m"].defaulted() || given.count("probe") != 0;
}

/// Reads the operating range into the arguments of an experiment that has one.
void read_operating(const po::variables_map& given, auto& arguments) {
  const bool in_hz = given.count("operating-hz") != 0, in_rpm = given.count("operating-rpm") != 0;
  if (in_hz && in_rpm) throw UsageError("--operating-hz and --operating-rpm exclude each other");
  if (!in_hz && !in_rpm) return;
  const char* option = in_hz ? "operating-hz" : "operating-rpm";
  arguments.operating_option = fmt::format("--{}", option);
  arguments.operating =
      operating_range_of(option, given[option].as<std::string>(), in_hz ? 1 : model::rpm_per_hz);
}

/// Reads the arguments of the rotor report; its directory becomes that of the results.
void read_rotor_report(const po::variables_map& given, RubtraceArguments& arguments) {
  if (given.count("rotor-report") == 0) return;
  const std::filesystem::path directory = given["rotor-report"].as<std::string>();
  if (directory.empty()) throw UsageError("--rotor-report: allowed: the name of a directory");
  if (given.count("output") != 0) throw UsageError("--output: --rotor-report names the directory itself");
  RotorReportArguments report;
  read_operating(given, report);
  if (arguments.action == Action::run)
    report.page.emplace(directory / "rotor_report.html", "rotor-report", Figure::Kind::page);
  arguments.output = directory;
  arguments.rotor_report = std::move(report);
}

/// Reads the arguments of the design check, and nothing else.
void read_design_check(const po::variables_map& given, RubtraceArguments& arguments) {
  if (given.count("design-check") == 0) {
    if (!arguments.rotor_report && (given.count("operating-hz") != 0 || given.count("operating-rpm") != 0))
      throw UsageError("--operating-hz and --operating-rpm belong to --design-check and --rotor-report");
    for (const char* name : {"stage", "gas-density", "require-pass"})
      if (given.count(name) != 0) throw UsageError(fmt::format("--{} belongs to --design-check", name));
    for (const char* name : {"kick-speeds", "threads"})
      if (!given[name].defaulted()) throw UsageError(fmt::format("--{} belongs to --design-check", name));
    if (given.count("other-end") != 0) throw UsageError("--other-end belongs to --design-check");
    return;
  }
  DesignCheckArguments check;
  read_operating(given, check);
  const long kick_speeds = given["kick-speeds"].as<long>();
  if (kick_speeds < 0 || kick_speeds > most_kick_speeds)
    throw UsageError(fmt::format("--kick-speeds: allowed: a number from 0 to {}", most_kick_speeds));
  check.kick_speeds = static_cast<int>(kick_speeds);
  check.threads = threads_of(given);
  if (given.count("stage") != 0) check.stages = stages_of(given["stage"].as<std::vector<std::string>>());
  if (given.count("gas-density") != 0) {
    check.gas_density_kg_per_m3 = given["gas-density"].as<double>();
    if (!(*check.gas_density_kg_per_m3 > 0 && *check.gas_density_kg_per_m3 < most_gas_density))
      throw UsageError(fmt::format("--gas-density: allowed: a number > 0 and < {}", most_gas_density));
  }
  check.require_pass = given.count("require-pass") != 0;
  if (given.count("other-end") != 0) check.other_end = given["other-end"].as<std::vector<std::string>>();
  arguments.design_check = std::move(check);
}

/// Throws UsageError where an option does not belong to the chosen experiment.
void refuse_options_of_others(const po::variables_map& given, const RubtraceArguments& arguments) {
  const bool sampled = arguments.free_response || (arguments.run_up && !arguments.with_stops);
  if (!sampled && !given["duration-s"].defaulted())
    throw UsageError("--duration-s belongs to --free-response");
  const bool experiment =
      arguments.campbell || arguments.run_up || arguments.design_check || arguments.rotor_report;
  if (!sampled && experiment && asks_for_probes(given))
    throw UsageError(
        "--sample-s, --noise-m and --probe belong to a trace, --sample-s and --noise-m also to "
        "--free-response "
        "and --run-up without stops");
}

/// Reads the experiments without contact; returns false where a trace is wanted.
bool read_experiment(const po::variables_map& given, RubtraceArguments& arguments) {
  arguments.free_response = given.count("free-response") != 0;
  if (given.count("run-up") != 0) arguments.run_up = ramp_of(given["run-up"].as<std::string>());
  if (given.count("campbell") != 0)
    arguments.campbell = campbell_speeds_of(given["campbell"].as<std::string>());
  arguments.with_stops = given.count("with-stops") != 0;
  read_rotor_report(given, arguments);
  read_design_check(given, arguments);
  if (arguments.with_stops && !arguments.run_up) throw UsageError("--with-stops belongs to --run-up");
  if (given.count("figure") != 0 && (arguments.free_response || arguments.rotor_report))
    throw UsageError("--figure belongs to a trace, to --campbell, to --run-up or to --design-check");
  const bool sampled = arguments.free_response || (arguments.run_up && !arguments.with_stops);
  const int others = static_cast<int>(arguments.free_response) + arguments.run_up.has_value() +
                     arguments.campbell.has_value() + arguments.design_check.has_value();
  if (others > 1)
    throw UsageError("--free-response, --run-up, --campbell and --design-check exclude each other");
  if (arguments.rotor_report && others > 0)
    throw UsageError("--rotor-report excludes --free-response, --run-up, --campbell and --design-check");
  arguments.duration_s = positive_number(given, "duration-s").value();
  arguments.sample_s = positive_number(given, "sample-s").value();
  arguments.noise_m = not_negative_number(given, "noise-m").value();
  refuse_options_of_others(given, arguments);
  if (given.count("probe") != 0) {
    if (sampled) throw UsageError("--probe belongs to a trace");
    if (!given["noise-m"].defaulted())
      throw UsageError(
          "--noise-m is that of a machine's sensors; the noise of a --probe stands behind its angle");
    for (const std::string& text : given["probe"].as<std::vector<std::string>>())
      arguments.probe.push_back(probe_of(text));
  }
  arguments.probes = !sampled && asks_for_probes(given);
  if (others == 0 && !arguments.rotor_report) return false;
  for (const std::string name : {"speed-hz", "speed-rpm", "whirl-ratio", "revolutions", "last-revolutions"}) {
    if (arguments.rotor_report && name.starts_with("speed")) continue;  // arguments of the deflected shape
    if (given.count(name) != 0)
      throw UsageError(fmt::format("--{} belongs to a trace, not to an experiment", name));
  }
  if (arguments.campbell) {
    for (const char* name : {"eccentricity-m", "unbalance-g-mm"}) {
      if (given.count(name) != 0)
        throw UsageError(fmt::format("--{} belongs to a trace or a run-up, not to --campbell", name));
    }
    return true;
  }
  if (arguments.design_check || arguments.rotor_report) return true;
  double duration_s = arguments.duration_s;
  if (auto& ramp = arguments.run_up) {
    if (!arguments.place.has_unbalance())
      throw UsageError("the unbalance of the run-up is needed: --eccentricity-m E or --unbalance-g-mm G");
    if (arguments.with_stops) return true;
    duration_s = (ramp->to_hz - ramp->from_hz) / ramp->rate_hz_per_s;
  }
  if (duration_s / arguments.sample_s > linear::most_samples) {
    throw UsageError(
        fmt::format("--sample-s: allowed: long enough for {} samples or fewer", linear::most_samples));
  }
  return true;
}

}  // namespace

RubtraceArguments parse_rubtrace_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, rubtrace_options());
  RubtraceArguments arguments{study_arguments(given, "rubtrace")};
  if (arguments.action == Action::help || arguments.action == Action::version) return arguments;
  if (arguments.action == Action::run) arguments.figure = figure_of(given);
  arguments.place = read_place(given);
  arguments.shown = shown_lengths_of(given);
  if (read_experiment(given, arguments)) return arguments;
  // --check and --explain without a cell apply to the whole sweep.
  const bool names_cell = arguments.place.speed_hz || arguments.place.has_unbalance();
  if (arguments.action != Action::run && !names_cell) return arguments;
  if (!arguments.place.speed_hz) throw UsageError("the shaft speed is needed: --speed-hz S or --speed-rpm N");
  if (!arguments.place.has_unbalance())
    throw UsageError(fmt::format("the unbalance is needed, one way: {}", unbalance_options));
  arguments.revolutions = count_of(given, "revolutions");
  arguments.last_revolutions = count_of(given, "last-revolutions");
  return arguments;
}

}  // namespace rubsweep::apps
