#include "rubtrace_arguments.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/analysis/linear/experiment.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"
#include "shared/shown_lengths.hpp"
#include "speed_ranges.hpp"

namespace rubsweep::apps {
namespace {

constexpr long most_kick_speeds = 1000;
constexpr double most_gas_density = 1e4;  // in kg/m3

constexpr std::string_view examples =
    "Examples:\n"
    "  rubtrace configs/benchmark/one_side.yaml --speed-hz 75 --whirl-ratio 0.3\n"
    "  rubtrace configs/minimal.yaml --speed-rpm 3240 --unbalance-g-mm 240 --output /tmp/trace\n"
    "  rubtrace configs/minimal.yaml --speed-hz 54 --eccentricity-m 3e-4 --revolutions 100 --output "
    "/tmp/trace\n"
    "  rubtrace configs/minimal.yaml --speed-hz 90 --whirl-ratio 0.6 --length-unit um --figure "
    "/tmp/trace.png\n"
    "  rubtrace configs/rotor_kit.yaml --speed-hz 70 --whirl-ratio 0.6 --sample-s 1e-3 --noise-m 2e-6\n"
    "  rubtrace configs/rotor_kit.yaml --free-response --noise-m 1e-6\n"
    "  rubtrace configs/minimal.yaml --speed-hz 90 --whirl-ratio 0.6 --probe stop0:acceleration:90\n"
    "  rubtrace configs/rotor_kit.yaml --run-up 10:60:1 --eccentricity-m 2e-5 --figure /tmp/bode.png\n"
    "  rubtrace configs/minimal.yaml --run-up 20:60:1 --eccentricity-m 2e-4 --with-stops --figure "
    "/tmp/run_up.png\n"
    "  rubtrace configs/rotor_kit.yaml --campbell 0:400\n"
    "  rubtrace configs/rotor_kit.yaml --run-up 10:60:1 --eccentricity-m 2e-5 --explain\n"
    "  rubtrace configs/gallery/bearing_table.yaml --design-check --figure /tmp/design.png\n"
    "  rubtrace configs/gallery/ross_rotor.yaml --rotor-report /tmp/rotor\n\n";

constexpr std::string_view written_files =
    "Writes into DIR, stops counted from 0, times from the start of the kick, or of the run:\n"
    "  trajectory.csv  displacement and velocity of the rotor; casing, gap and forces of every stop "
    "(forces on\n"
    "                  the casing); N revolutions of response.samples_per_revolution samples\n"
    "  section.csv     the state once per revolution, at the phase of smallest quiet gap, from revolution "
    "0\n"
    "  events.csv      changes of contact mode: open, clamped, sprung, released; none with contact: "
    "smoothed\n"
    "  sensors.csv     with --sample-s or --noise-m: what the sensors of a rotor kit read; of a Jeffcott "
    "rotor "
    "x and y\n"
    "  probe_spectrum.csv  full spectrum of the last of these readings, of two sensors at one place\n"
    "  spectrum.csv    full spectrum of the last whole periods in response.window_revolutions revolutions\n"
    "  motion.csv      the row that a map holds of this cell, with its own number of revolutions\n"
    "  config.yaml     the complete configuration, its sweep reduced to this cell\n"
    "An experiment writes sensors.csv (what the sensors of a rotor kit read; of a Jeffcott rotor x and y), "
    "bode.csv "
    "(run-up:\n"
    "1X amplitude and phase over speed), identification.csv (quantity, sensor, value) and config.yaml. A "
    "Campbell\n"
    "diagram is campbell.csv (frequency and damping of each whirl mode over speed), critical_speeds.csv, "
    "mode_shapes.csv\n"
    "(along the shaft, at the first critical speed of each mode), lock_speeds.csv (where two modes can "
    "lock into a "
    "bouncing rub)\n"
    "and config.yaml; modes that come below "
    "twice "
    "TO.\n"
    "A run-up with stops writes envelope.csv, orbits.csv, spectrogram.csv (of orders), quasi_static.csv "
    "(the "
    "motions at\n"
    "steady speeds), rub.csv (where either rubs) and config.yaml.\n\n"
    "A design check writes design_check.csv (each check with value, limit, margin and verdict), "
    "unbalance_response.csv\n"
    "(scaled, over the speed), lock_speeds.csv, kicks.csv and config.yaml; with --other-end also\n"
    "design_check_other_end.csv and config_other_end.yaml. Its unbalance is --eccentricity-m or "
    "--unbalance-g-mm;\n"
    "default: four times the residual one of API 617.\n"
    "A rotor report writes rotor_report.html, a page with all pictures, and its tables: rotor_parts.csv, "
    "static_line.csv,\n"
    "bearing_loads.csv, critical_map.csv, bearing_stiffness.csv, stability.csv, deflected_shape.csv (at "
    "--speed-hz; default:\n"
    "the highest speed), report_notes.csv (what is left out and why), and those of a Campbell diagram.\n\n";

po::options_description visible_options() {
  po::options_description options("Options");
  add_place(options);
  options.add_options()(
      "revolutions", po::value<long>()->value_name("N"),
      "revolutions to run from the start of the kick, never fewer; default: response.max_revolutions")(
      "last-revolutions", po::value<long>()->value_name("M"),
      "only the last M revolutions go into trajectory.csv; default: all")(
      "free-response",
      "instead: response to the kick at standstill without stops, and the frequency and damping fitted to "
      "it")("run-up", po::value<std::string>()->value_name("FROM:TO:RATE"),
            "instead: speed ramp without stops in Hz:Hz:Hz/s with --eccentricity-m or --unbalance-g-mm; Bode "
            "plot and speed of the largest 1X")(
      "with-stops",
      "of --run-up: through rub; envelope, orbits and spectrogram of orders, and where it rubs beside where "
      "it does "
      "at steady speeds")(
      "campbell", po::value<std::string>()->value_name("FROM:TO[:COUNT]"),
      "instead: whirl frequencies without stops over COUNT (101) shaft speeds in Hz; critical speeds, "
      "shapes")(
      "design-check",
      "instead: vibration limit, clearances, dry whip, lock speeds and smallest kick over the operating "
      "range")("operating-hz", po::value<std::string>()->value_name("FROM:TO"),
               "of --design-check and --rotor-report: operating range; default: the speeds of the sweep")(
      "operating-rpm", po::value<std::string>()->value_name("FROM:TO"), "the same in revolutions per minute")(
      "kick-speeds", po::value<long>()->value_name("N")->default_value(11),
      "of --design-check: evenly spaced speeds at which kicks are tried, beside the lock speeds; 0: none")(
      "other-end", po::value<std::vector<std::string>>()->value_name("KEY=VALUE"),
      "of --design-check, for each key: what is different at the other end of the bearings' clearances, such "
      "as a table; both ends are checked")(
      "stage", po::value<std::vector<std::string>>()->value_name("STAGE"),
      "of --design-check, for each stage: impeller:KW:DENSITY_RATIO:DIAMETER_MM:WIDTH_MM or "
      "blades:KW:DIAMETER_MM:HEIGHT_MM, whose power drives cross-coupling; none: the rotor does no work")(
      "gas-density", po::value<double>()->value_name("KG_PER_M3"),
      "of --design-check: mean density of the gas, for region A or B of Level I")(
      "require-pass", "of --design-check: exit code 4 where the answer is not pass")(
      "rotor-report", po::value<std::string>()->value_name("DIR"),
      "instead: a page DIR/rotor_report.html with the rotor, Campbell diagram, stability, critical speed "
      "map, "
      "static line, deflected shape and modes, and their tables")(
      "duration-s", po::value<double>()->value_name("T")->default_value(2), "length of the free response")(
      "sample-s", po::value<double>()->value_name("T")->default_value(1e-3),
      "sampling time of the sensors; given with a trace: sensors.csv, probe_spectrum.csv and the period that "
      "they show")("noise-m", po::value<double>()->value_name("S")->default_value(0),
                   "standard deviation of the sensors' noise; likewise")(
      "probe", po::value<std::vector<std::string>>()->value_name("PROBE"),
      "of a trace, for each probe, in place of the machine's sensors: PLACE:QUANTITY:ANGLE[:NOISE] with "
      "PLACE shaft, stopN (its casing) or shaft-stopN (relative to it); QUANTITY displacement, velocity or "
      "acceleration; ANGLE in degrees from +x; NOISE a standard deviation in m, m/s or m/s2");
  add_threads(options, "threads of --design-check; 0: one per processor");
  add_figure(options,
             "draw a trace, a Campbell diagram, a run-up (Bode plot), one with stops or a design check as "
             "FILE.png, .svg "
             "or .pdf");
  add_output(options, "write there instead of output.directory + _trace");
  add_shown_lengths(options);
  add_set(options);
  add_actions(options, "say what is simulated, what is left out and why, run nothing");
  add_last(options);
  return options;
}

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
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
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

std::string rubtrace_help() {
  return fmt::format(
      "rubtrace CONFIG.yaml (--speed-hz S | --speed-rpm N) (--whirl-ratio U | --eccentricity-m E | "
      "--unbalance-g-mm G) [options]\n"
      "One cell of a map under the lens: the motion from the start of the kick, all its revolutions.\n\n"
      "{}\n"
      "{}"
      "From a whirl ratio of 1, where the quiet whirl itself reaches the wall, the run starts at rest and "
      "without a "
      "kick.\n\n"
      "{}"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 the run failed, the files end at "
      "the\n"
      "failure, or there was nothing to run (motion.csv and config.yaml only). An interrupted run writes "
      "nothing.\n",
      text_of(visible_options()), examples, written_files);
}

}  // namespace rubsweep::apps
