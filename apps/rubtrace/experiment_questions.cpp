#include "experiment_questions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "design_check.hpp"
#include "explain/explain_machine.hpp"
#include "explain/explain_rotor.hpp"
#include "rotor_report.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"
#include "shared/premises.hpp"

namespace rubsweep::apps {
namespace {

/// Number of speeds at which the machine of an experiment is checked.
constexpr int looked_at = 121;

/// Description of an experiment, and the speeds of its machine.
struct AskedExperiment {
  std::string text;
  std::vector<double> speeds_hz;
};

AskedExperiment over_speeds(const std::string& text, double from_hz, double to_hz) {
  const auto [low_hz, high_hz] = std::minmax(from_hz, to_hz);
  std::vector<double> speeds_hz = batch::evenly_spaced(low_hz, high_hz, looked_at);
  std::erase(speeds_hz, 0);
  return {text + model::speed_range_text(from_hz, to_hz), std::move(speeds_hz)};
}

AskedExperiment experiment_of(const RubtraceArguments& arguments, const sweep::Study& study) {
  if (arguments.design_check) {
    read_other_end(arguments);
    const design::SpeedRange operating = operating_range(*arguments.design_check, study);
    return over_speeds("design check over the operating range, ", operating.from_hz, operating.to_hz);
  }
  if (arguments.rotor_report) {
    const ReportSpeeds speeds = report_speeds(arguments, study);
    return over_speeds("rotor report without the stops, ", speeds.shown.from_hz, speeds.shown.to_hz);
  }
  if (const auto& speeds = arguments.campbell) {
    structure::refuse_beyond_tables(study.machine, speeds->from_hz, speeds->to_hz);
    return over_speeds(fmt::format("Campbell diagram without the stops, {} speeds, ", speeds->count),
                       speeds->from_hz, speeds->to_hz);
  }
  if (const auto& ramp = arguments.run_up) {
    return over_speeds(
        fmt::format("run-{} {} the stops by {:.6g} Hz a second, eccentricity {:.6g} m, ",
                    ramp->to_hz > ramp->from_hz ? "up" : "down", arguments.with_stops ? "with" : "without",
                    ramp->rate_hz_per_s, ramp->eccentricity_m),
        ramp->from_hz, ramp->to_hz);
  }
  return {fmt::format("response to the kick at standstill without the stops, {} s", arguments.duration_s),
          {}};
}

/// Text of --explain. Contact is explained at a speed of the configuration, because a Campbell diagram may
/// begin at standstill.
std::string explanation(const AskedExperiment& asked, const sweep::Study& study) {
  const double slowest_hz = *std::ranges::min_element(study.grid.speed_hz);
  std::string text = fmt::format("experiment: {}\n{}", asked.text,
                                 explain_machine(study.machine, slowest_hz, study.stop_names));
  if (asked.speeds_hz.empty()) return text;
  sweep::Study turning = study;
  turning.grid.speed_hz = asked.speeds_hz;
  return text + explain_tables(study.machine, asked.speeds_hz) + describe_sparse_tables(study.machine) +
         sweep::where_rotor_is_unstable(turning, scene::prepare_machine(study.machine));
}

}  // namespace

StudyActions experiment_actions(const RubtraceArguments& arguments, const config::RunConfig& config,
                                std::function<int()> run) {
  const sweep::Study& study = config.study;
  return {.size =
              [&] {
                const AskedExperiment asked = experiment_of(arguments, study);
                const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
                if (!asked.speeds_hz.empty())
                  warn_of_premises_at("rubtrace", asked.speeds_hz, study, prepared);
                return asked.text;
              },
          .explanation = [&] { return explanation(experiment_of(arguments, study), study); },
          .configuration = [&] { return config::print_config(config); },
          .run = std::move(run)};
}

}  // namespace rubsweep::apps
