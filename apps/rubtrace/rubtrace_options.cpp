#include "rubtrace_options.hpp"

#include <fmt/format.h>

#include <string_view>

#include "shared/figure.hpp"
#include "shared/place_arguments.hpp"
#include "shared/shown_lengths.hpp"

namespace rubsweep::apps {
namespace {

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

}  // namespace

po::options_description rubtrace_options() {
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
      text_of(rubtrace_options()), examples, written_files);
}

}  // namespace rubsweep::apps
