#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "design_check.hpp"
#include "experiment.hpp"
#include "experiment_questions.hpp"
#include "experiment_tables.hpp"
#include "motion_summary.hpp"
#include "probe_argument.hpp"
#include "rotor_report.hpp"
#include "rubsweep/analysis/linear/experiment.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/analysis/trace/probe.hpp"
#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/study_columns.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "rubsweep/maps/sweep/hertz_secant.hpp"
#include "rubtrace_arguments.hpp"
#include "rubtrace_options.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/shown_lengths.hpp"
#include "shared/study_questions.hpp"
#include "shared/working_time.hpp"
#include "trace_csv.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// All files that a trace may write.
constexpr std::array<std::string_view, 8> file_names{"config.yaml", "motion.csv",        "trajectory.csv",
                                                     "section.csv", "events.csv",        "spectrum.csv",
                                                     "sensors.csv", "probe_spectrum.csv"};

/// Fewest probe readings from which a period can be found.
constexpr int fewest_readings = 16;

fs::path directory_of(const RubtraceArguments& arguments, const config::RunConfig& config) {
  return results_directory(arguments, config.output_directory, "_trace");
}

int cannot_start(scene::Start start) {
  say(fmt::format(
      "rubtrace: {}; no trace, motion.csv only\n",
      start == scene::Start::initial_contact
          ? "static forces press the rotor on the wall, so that no unbalance gives this whirl ratio; "
            "give --eccentricity-m instead"
          : "no eccentricity gives this whirl ratio at this speed, or there is no quiet motion"));
  return some_cells_failed;
}

/// Throws, before anything is computed, where the trace needs more memory than the machine has.
void refuse_more_memory_than_there_is(const trace::TraceOptions& options, std::size_t stops,
                                      Eigen::Index coordinates) {
  const double needed = trace::trace_bytes(options, stops, coordinates),
               there = static_cast<double>(batch::machine_memory_bytes());
  if (needed <= there) return;
  throw ConfigError(fmt::format(
      "--revolutions: {} revolutions take about {:.3g} GB of memory, this machine has {:.3g} GB, allowed: "
      "fewer --revolutions or --last-revolutions",
      options.revolutions, needed / 1e9, there / 1e9));
}

trace::Probes probes_of(const RubtraceArguments& arguments, const scene::PreparedMachine& prepared,
                        const std::vector<std::string>& stop_names, long revolutions) {
  const double readings =
      static_cast<double>(revolutions) / (arguments.place.speed_hz.value() * arguments.sample_s);
  if (readings > linear::most_samples) {
    throw UsageError(
        fmt::format("--sample-s: allowed: long enough for {} samples or fewer", linear::most_samples));
  }
  if (readings < fewest_readings)
    throw UsageError(
        fmt::format("--sample-s: allowed: short enough for {} samples or more", fewest_readings));
  if (!arguments.probe.empty()) return probes_of(arguments.probe, prepared, arguments.sample_s, stop_names);
  const linear::SensorRows sensors = linear::sensor_rows(prepared);
  trace::Probes probes{sensors.rows, sensors.angle_deg, arguments.sample_s};
  probes.noise.assign(probes.angle_deg.size(), arguments.noise_m);
  for (std::size_t i = 0; i < probes.angle_deg.size(); ++i)
    probes.name.push_back(model::sensor_name(prepared.machine, i));
  return probes;
}

std::vector<double> places_of_probes(const RubtraceArguments& arguments, const model::Machine& machine) {
  if (!arguments.probe.empty()) return places_of(arguments.probe);
  std::vector<double> places;
  if (const model::RotorKit* kit = model::kit_of(machine)) {
    for (const model::Sensor& sensor : kit->sensors) places.push_back(sensor.position_m);
  }
  return places;
}

/// Adds the readings of the probes. Returns a text that compares the period found from the probes with that
/// of the section.
std::string look_by_probes(const trace::Trace& trace, const trace::Probes& probes, double speed_hz,
                           const sweep::Study& study, const RubtraceArguments& arguments,
                           response::motion::Workspace& workspace, batch::ResultFiles& files) {
  files["sensors.csv"] = sensors_csv(
      {.from_hz = speed_hz, .sample_s = probes.sample_s, .samples = static_cast<int>(trace.readings.rows())},
      trace.readings, probes.derivative);
  const auto pair = trace::pair_of(probes.angle_deg, places_of_probes(arguments, study.machine));
  if (!pair) return "probes    no two of them see one place from two directions\n";
  const auto z = trace::displacement_of(trace.readings, *pair, probes.angle_deg);
  const int turns = static_cast<int>(std::min<long>(trace.revolutions, study.response.window_revolutions));
  const trace::ProbePeriod period =
      trace::find_period(z, probes.sample_s, speed_hz, probes.noise_m(), turns, study.response.max_order);
  const auto spectrum = trace::probe_spectrum(z, probes.sample_s, speed_hz, turns, period.period.value_or(1),
                                              workspace.spectrum);
  files["probe_spectrum.csv"] = spectrum_csv(spectrum, speed_hz);
  return probe_summary(period, *pair, probes, arguments.shown);
}

trace::TraceOptions options_of(const RubtraceArguments& arguments, const sweep::Study& study,
                               double speed_hz) {
  return {.speed_hz = speed_hz,
          .revolutions = arguments.revolutions.value_or(study.response.max_revolutions),
          .samples_per_revolution = study.response.samples_per_revolution,
          .window_revolutions = study.response.window_revolutions,
          .trajectory_revolutions = arguments.last_revolutions};
}

/// Adds the trace's files and text to those of the row.
void add_trace(const trace::Trace& trace, const trace::TraceOptions& options, const sweep::Study& study,
               const sweep::Row& row, double length_scale_m, const RubtraceArguments& arguments,
               response::motion::Workspace& workspace, batch::ResultFiles& files, std::string& summary) {
  const trace::TraceWindow window = trace::last_window(trace, options, row.order, workspace.spectrum);
  files["trajectory.csv"] = trajectory_csv(trace);
  files["section.csv"] = section_csv(trace);
  files["events.csv"] = events_csv(trace);
  files["spectrum.csv"] = spectrum_csv(window.spectrum, options.speed_hz);
  summary += trace_summary(trace, window, length_scale_m, arguments.shown);
  if (options.probes)
    summary += look_by_probes(trace, *options.probes, options.speed_hz, study, arguments, workspace, files);
}

/// Reduces the study to this cell.
void reduce_to_cell(const PlaceArguments& place, sweep::Study& study) {
  study.grid = sweep::grid_of(scene::Place{place.speed_hz.value(), unbalance_of(place, study.machine)});
  keep_units(place, study);
}

/// Runs the trace; `config` contains only this cell.
int run(const RubtraceArguments& arguments, const config::RunConfig& config) {
  const sweep::Study& study = config.study;
  const scene::Place place = sweep::place_of(study.grid, 0);
  trace::TraceOptions options = options_of(arguments, study, place.speed_hz);
  const scene::PreparedMachine prepared =
      scene::prepared_at(scene::prepare_machine(study.machine), place.speed_hz);
  if (!arguments.quiet) warn_of_premises("rubtrace", study, prepared);
  if (arguments.probes)
    options.probes = probes_of(arguments, prepared, study.stop_names, options.revolutions);
  refuse_more_memory_than_there_is(options, study.machine.stops.size(),
                                   prepared.assembly.system.coordinates());
  const fs::path directory = directory_of(arguments, config);
  const ResultDirectory made(directory, file_names);

  std::optional<WorkingTime> working(std::in_place, "rubtrace", "runs the cell", !arguments.quiet);
  response::motion::Workspace workspace;
  const sweep::Row row = sweep::evaluate_cell(study, prepared, 0, workspace);
  batch::ResultFiles files{
      {"config.yaml", config::print_config(config)},
      {"motion.csv", report::map_comments() + report::map_header(study) + report::unit_header(study.grid) +
                         "\n" + report::map_line(row, study) + report::unit_cells(row, study.grid) + "\n"}};
  std::string summary = motion_summary(row, arguments.shown);

  // The cell runs a second time. The first run, which classifies, stops once the motion is proven and has
  // other samples, so that its steps differ from those of a trace of all revolutions.
  const std::optional<double> secant_n = row.hertz ? std::optional(row.hertz->force_n) : std::nullopt;
  const scene::Cell cell =
      scene::build_cell(sweep::with_secant_of_row(prepared, secant_n), place.speed_hz, place.unbalance);
  trace::Trace trace;
  if (scene::can_run(cell.start)) {
    trace = trace::trace_run(integrate::start(cell.scene, study.solver, workspace.modes).advance, cell.scene,
                             study.solver, options);
    add_trace(trace, options, study, row, cell.scene.length_scale_m, arguments, workspace, files, summary);
  }
  working.reset();
  {
    const InterruptsWait whole_set;
    batch::write_result_files(
        files, file_names, directory,
        {"rubsweep", config::study_digest(study), batch::caption_lines(config.captions)});
    end_on_interrupts("the files are written, no figure is");
  }
  count_in_summary("revolutions", static_cast<std::size_t>(trace.revolutions));
  if (!arguments.quiet) print("{}{}", summary, batch::files_line(files, directory));
  if (trace.revolutions > 0)
    draw_and_say(arguments.figure, "trace", directory, "One cell under the lens", arguments.quiet,
                 drawn_lengths(arguments.shown, true, false));
  if (!scene::can_run(cell.start)) return cannot_start(cell.start);
  if (trace.outcome == integrate::run::Outcome::ok) return done;
  say(fmt::format("rubtrace: the run failed in revolution {}: {}; the files end there\n",
                  trace.revolutions + 1, integrate::run::to_string(trace.outcome)));
  return some_cells_failed;
}

int perform(RubtraceArguments arguments) {
  if (answered("rubtrace", arguments.action, rubtrace_help)) return done;
  end_on_interrupts("nothing was written");  // preparing a rotor may take a second
  config::RunConfig config = config::read_cell_config(arguments.config, arguments.overrides);
  ask("rubtrace", config.questions, arguments.quiet);
  if (arguments.place.has_unbalance())
    ask_about("rubtrace", unbalance_of(arguments.place, config.study.machine), config.study.machine,
              arguments.quiet);
  if (arguments.place.speed_hz) require_speed("--speed-hz", *arguments.place.speed_hz, config.study.machine);
  if (const auto& speeds = arguments.campbell)
    require_speed("--campbell", speeds->to_hz, config.study.machine);
  if (auto& ramp = arguments.run_up) {
    require_speed("--run-up", std::max(ramp->from_hz, ramp->to_hz), config.study.machine);
    const scene::Unbalance unbalance = unbalance_of(arguments.place, config.study.machine);
    ramp->eccentricity_m = std::get<scene::Eccentricity>(unbalance).value_m;
  }
  if (arguments.design_check || arguments.free_response || arguments.run_up || arguments.campbell ||
      arguments.rotor_report) {
    return act(arguments, experiment_actions(arguments, config, [&] {
                 const fs::path directory = directory_of(arguments, config);
                 if (arguments.rotor_report) return run_rotor_report(arguments, config, directory);
                 return arguments.design_check ? run_design_check(arguments, config, directory)
                                               : run_experiment(arguments, config, directory);
               }));
  }
  if (arguments.place.speed_hz) reduce_to_cell(arguments.place, config.study);
  return act(arguments, study_actions("rubtrace", arguments, config, [&] { return run(arguments, config); }));
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubtrace", [&] { return perform(parse_rubtrace_arguments(argc, argv)); });
}
