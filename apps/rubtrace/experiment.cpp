#include "experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "campbell_tables.hpp"
#include "experiment_tables.hpp"
#include "ramp_tables.hpp"
#include "rubsweep/analysis/line/follow_line.hpp"
#include "rubsweep/analysis/linear/campbell.hpp"
#include "rubsweep/analysis/linear/experiment.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubtrace/ramp_record.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/shown_lengths.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

/// All files that an experiment may write.
constexpr std::array<std::string_view, 13> experiment_file_names{
    "config.yaml",         "sensors.csv",     "bode.csv",       "identification.csv", "campbell.csv",
    "critical_speeds.csv", "mode_shapes.csv", "envelope.csv",   "orbits.csv",         "spectrogram.csv",
    "quasi_static.csv",    "rub.csv",         "lock_speeds.csv"};

/// Number of steady speeds with which a run-up with stops is compared.
constexpr int steady_speeds = 121;
/// Samples per turn at the highest speed.
constexpr int ramp_samples = 128;

/// Files of an experiment except its configuration, and its result for a terminal.
struct Outcome {
  batch::ResultFiles files;
  std::string summary;
  integrate::run::Outcome run = integrate::run::Outcome::ok;  ///< outcome of a run-up with stops
};

Outcome outcome_of(ExperimentTables tables) {
  return {{{"sensors.csv", std::move(tables.sensors_csv)},
           {"bode.csv", std::move(tables.bode_csv)},
           {"identification.csv", std::move(tables.identification_csv)}},
          std::move(tables.summary)};
}

Outcome campbell_diagram(const CampbellSpeeds& asked, const model::Machine& machine) {
  structure::refuse_beyond_tables(machine, asked.from_hz, asked.to_hz);
  const std::vector<double> speeds_hz = batch::evenly_spaced(asked.from_hz, asked.to_hz, asked.count);
  CampbellTables tables =
      tables_of(linear::campbell(linear::free_rotor(machine), speeds_hz, 2 * asked.to_hz));
  return {{{"campbell.csv", std::move(tables.campbell_csv)},
           {"critical_speeds.csv", std::move(tables.critical_speeds_csv)},
           {"mode_shapes.csv", std::move(tables.mode_shapes_csv)},
           {"lock_speeds.csv", std::move(tables.lock_speeds_csv)}},
          std::move(tables.summary)};
}

/// Motions at steady speeds, in the order of the ramp; each one starts from the motion before.
std::vector<line::LinePoint> steady_motions(const ramp::SpeedRamp& ramp, const sweep::Study& study,
                                            const scene::PreparedMachine& machine) {
  const auto shared_study = std::make_shared<const sweep::Study>(study);
  const auto shared_machine = std::make_shared<const scene::PreparedMachine>(machine);
  std::vector<line::LineCell> cells;
  for (const double speed_hz : batch::evenly_spaced(ramp.from_hz, ramp.to_hz, steady_speeds)) {
    cells.push_back(
        {speed_hz, shared_study, shared_machine, {speed_hz, scene::Eccentricity{ramp.eccentricity_m}}});
  }
  std::vector<line::LinePoint> points;
  const std::array passes{line::Pass::up};
  const std::atomic<bool> never{false};
  line::follow_line(
      cells, passes, 1, [&](line::LinePoint&& point) { points.push_back(std::move(point)); }, never);
  return points;
}

/// Runs up without a kick, so that only the unbalance brings the rotor to the wall. An initial state is used
/// only if it is the state at rest.
Outcome run_up_with_stops(const ramp::SpeedRamp& ramp, sweep::Study study, const model::ShownLengths& shown) {
  study.machine = model::without_kicks(std::move(study.machine));
  if (!model::begins_at_rest(study.machine.start)) study.machine.start.reset();
  const scene::PreparedMachine machine = scene::prepare_machine(study.machine);
  ramp::RampRecord record(ramp);
  const integrate::run::Outcome run =
      ramp::run_ramp(machine, ramp, study.solver, ramp_samples,
                     [&](const ramp::RampStretch& stretch) { record.add(stretch); });
  RampTables tables = tables_of(record, steady_motions(ramp, study, machine), shown);
  return {{{"envelope.csv", std::move(tables.envelope_csv)},
           {"orbits.csv", std::move(tables.orbits_csv)},
           {"spectrogram.csv", std::move(tables.spectrogram_csv)},
           {"quasi_static.csv", std::move(tables.quasi_static_csv)},
           {"rub.csv", std::move(tables.rub_csv)}},
          std::move(tables.summary),
          run};
}

/// Warns about unstable steady speeds within the range of a ramp.
void warn_of_ramp(const ramp::SpeedRamp& ramp, const sweep::Study& study,
                  const scene::PreparedMachine& machine) {
  warn_of_premises_at("rubtrace", batch::evenly_spaced(ramp.from_hz, ramp.to_hz, steady_speeds), study,
                      machine);
}

Outcome perform(const RubtraceArguments& arguments, const sweep::Study& study) {
  const model::Machine& described = study.machine;
  const scene::PreparedMachine machine = scene::prepare_machine(described);
  if (arguments.run_up && !arguments.quiet) warn_of_ramp(*arguments.run_up, study, machine);
  if (arguments.with_stops) return run_up_with_stops(*arguments.run_up, study, arguments.shown);
  if (arguments.campbell) return campbell_diagram(*arguments.campbell, described);
  const linear::Sampling sampling{.sample_s = arguments.sample_s, .noise_m = arguments.noise_m};
  if (const auto& ramp = arguments.run_up) {
    return outcome_of(tables_of(linear::run_up(machine, ramp->from_hz, ramp->to_hz, ramp->rate_hz_per_s,
                                               ramp->eccentricity_m, sampling),
                                described, arguments.shown));
  }
  if (!machine.machine.kick) throw UsageError("--free-response: the configuration has no kick");
  const double slowest_hz = linear::lowest_frequency_hz(machine);
  if (!(2 * slowest_hz * sampling.sample_s < 1)) {
    throw UsageError(
        fmt::format("--sample-s: {} s are too long to see {:.4g} Hz, allowed: less than {:.4g} s",
                    sampling.sample_s, slowest_hz, 1 / (2 * slowest_hz)));
  }
  return outcome_of(tables_of(linear::free_response(machine, arguments.duration_s, sampling), described));
}

/// Picture type for rubplot, and the heading. Speeds in rpm stand at the axis, because they would make the
/// heading too long.
std::pair<const char*, std::string> drawing_of(const RubtraceArguments& arguments) {
  if (arguments.campbell) return {"campbell", "Campbell diagram"};
  const ramp::SpeedRamp& ramp = arguments.run_up.value();
  return {arguments.with_stops ? "run-up" : "bode",
          fmt::format("Run-{} {}, {:.4g} to {:.4g} Hz at {:.4g} Hz/s, eccentricity {:.4g} mm",
                      ramp.to_hz > ramp.from_hz ? "up" : "down",
                      arguments.with_stops ? "through rub" : "without stops", ramp.from_hz, ramp.to_hz,
                      ramp.rate_hz_per_s, 1e3 * ramp.eccentricity_m)};
}

}  // namespace

int run_experiment(const RubtraceArguments& arguments, const config::RunConfig& config,
                   const std::filesystem::path& directory) {
  const ResultDirectory made(directory, experiment_file_names);
  std::optional<WorkingTime> working(std::in_place, "rubtrace", "runs the experiment", !arguments.quiet);
  auto [files, summary, run] = perform(arguments, config.study);
  working.reset();
  files.emplace("config.yaml", config::print_config(config));
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  {
    const InterruptsWait whole_set;
    batch::write_result_files(
        files, experiment_file_names, directory,
        {"rubsweep", config::study_digest(config.study), batch::caption_lines(config.captions)});
    end_on_interrupts("the files are written, no figure is");
  }
  if (!arguments.quiet) print("{}{}", summary, batch::files_line(files, directory));
  if (arguments.figure) {
    const auto [picture, heading] = drawing_of(arguments);
    const bool is_bode = arguments.run_up && !arguments.with_stops;
    draw_and_say(arguments.figure, picture, directory, heading, arguments.quiet,
                 drawn_lengths(arguments.shown, is_bode, is_bode));
  }
  if (run == integrate::run::Outcome::ok) return done;
  say(fmt::format("rubtrace: the run-up failed: {}; the files end there\n", to_string(run)));
  return some_cells_failed;
}

}  // namespace rubsweep::apps
