#include "experiment_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::apps {

using namespace linear;

namespace {

using batch::csv_number;

std::string bode_csv(const std::vector<std::vector<BodePoint>>& plots) {
  std::string text = "speed_hz";
  for (std::size_t i = 0; i < plots.size(); ++i)
    text += fmt::format(",sensor_{0}_amplitude_m,sensor_{0}_phase_deg", i);
  text += '\n';
  for (std::size_t k = 0; k < plots.front().size(); ++k) {
    text += csv_number(plots.front()[k].speed_hz);
    for (const auto& plot : plots) {
      text.append(",").append(csv_number(plot[k].amplitude_m));
      text.append(",").append(csv_number(plot[k].phase_deg));
    }
    text += '\n';
  }
  return text;
}

void add(std::string& identification, const char* quantity, std::size_t sensor, double value) {
  identification += fmt::format("{},{},{}\n", quantity, sensor, csv_number(value));
}

ExperimentTables begun(const LinearRun& run, const Eigen::MatrixXd& signal_m) {
  return {.sensors_csv = sensors_csv(run, signal_m),
          .bode_csv = {},
          .identification_csv = "quantity,sensor,value\n",
          .summary = {}};
}

/// Unexplained share of a signal above which the text warns that more than one mode may be present.
constexpr double large_misfit = 0.05;

std::string resonance_text(const std::optional<RampResonance>& fit) {
  if (!fit) return "resonance: no single mode fits";
  return fmt::format("resonance by a fit to the ramp at {:.5g} Hz, damping ratio {:.4g}, misfit {:.2g}{}",
                     fit->frequency_hz, fit->damping_ratio, fit->misfit,
                     fit->misfit > large_misfit ? ": noise or more than one mode, not to be relied on" : "");
}

std::string why_none(const RunUp& run_up, std::size_t sensor, const model::ShownLengths& shown) {
  if (!run_up.sees[sensor]) return "does not see the unbalance";
  const auto& plot = run_up.bode[sensor];
  if (plot.empty()) {
    return fmt::format("no largest 1X: no {} revolutions with enough samples, run up more slowly",
                       bode_revolutions);
  }
  return fmt::format("no largest 1X inside: of what was measured, {}, 1X is largest at an end, {}",
                     model::speed_range_text(plot.front().speed_hz, plot.back().speed_hz, 5),
                     model::amplitude_text(run_up.largest_amplitude_m[sensor], shown, model::LengthUnit::m));
}

std::string sensor_of(const model::Machine& machine, std::size_t sensor, double angle_deg) {
  return "sensor " + model::sensor_label(sensor, model::sensor_name(machine, sensor), angle_deg);
}

}  // namespace

std::string sensors_csv(const LinearRun& run, const Eigen::MatrixXd& signal,
                        const std::vector<int>& derivative) {
  constexpr std::array<std::string_view, 3> units{"m", "m_per_s", "m_per_s2"};
  std::string text = "t_s,speed_hz,shaft_angle_rad";
  for (Eigen::Index i = 0; i < signal.cols(); ++i) {
    const int order = derivative.empty() ? 0 : derivative[static_cast<std::size_t>(i)];
    text += fmt::format(",sensor_{}_{}", i, units[static_cast<std::size_t>(order)]);
  }
  text += '\n';
  for (Eigen::Index k = 0; k < signal.rows(); ++k) {
    const double t = static_cast<double>(k) * run.sample_s;
    text += csv_number(t);
    for (const double value : {shaft_speed_hz(run, t), shaft_angle_rad(run, t)}) {
      text.append(",").append(csv_number(value));
    }
    for (Eigen::Index i = 0; i < signal.cols(); ++i) text.append(",").append(csv_number(signal(k, i)));
    text += '\n';
  }
  return text;
}

ExperimentTables tables_of(const FreeResponse& response, const model::Machine& machine) {
  ExperimentTables tables = begun(response.run, response.signal_m);
  for (std::size_t i = 0; i < response.decay.size(); ++i) {
    const std::string sensor = sensor_of(machine, i, response.angle_deg[i]);
    if (!response.decay[i]) {
      tables.summary += fmt::format("{}  does not see the kick\n", sensor);
      continue;
    }
    const FreeDecay& fit = *response.decay[i];
    add(tables.identification_csv, "natural_frequency_hz", i, fit.natural_frequency_hz);
    add(tables.identification_csv, "damping_ratio", i, fit.damping_ratio);
    add(tables.identification_csv, "misfit", i, fit.misfit);
    tables.summary += fmt::format("{}  natural frequency {:.5g} Hz, damping ratio {:.4g}, misfit {:.2g}\n",
                                  sensor, fit.natural_frequency_hz, fit.damping_ratio, fit.misfit);
  }
  return tables;
}

ExperimentTables tables_of(const RunUp& run_up, const model::Machine& machine,
                           const model::ShownLengths& shown) {
  ExperimentTables tables = begun(run_up.run, run_up.signal_m);
  for (std::size_t i = 0; i < run_up.bode.size(); ++i) {
    const std::optional<double> top_hz = run_up.speed_of_largest_1x_hz[i];
    const double largest_m = run_up.largest_amplitude_m[i];
    // Scripts still use this older name, although the quantity is a critical speed only on slow ramps.
    if (top_hz) add(tables.identification_csv, "critical_speed_hz", i, *top_hz);
    if (top_hz) add(tables.identification_csv, "speed_of_largest_1x_hz", i, *top_hz);
    if (run_up.sees[i] && !run_up.bode[i].empty())
      add(tables.identification_csv, "largest_amplitude_m", i, largest_m);
    if (const auto& fit = run_up.resonance[i]) {
      add(tables.identification_csv, "resonance_frequency_hz", i, fit->frequency_hz);
      add(tables.identification_csv, "resonance_damping_ratio", i, fit->damping_ratio);
      add(tables.identification_csv, "resonance_misfit", i, fit->misfit);
    }
    tables.summary += fmt::format(
        "{}  {}\n", sensor_of(machine, i, run_up.angle_deg[i]),
        top_hz ? fmt::format("1X largest at {} of this ramp, {}; {}", model::speed_text(*top_hz, 5),
                             model::amplitude_text(largest_m, shown, model::LengthUnit::m),
                             resonance_text(run_up.resonance[i]))
               : why_none(run_up, i, shown));
  }
  tables.bode_csv = bode_csv(run_up.bode);
  return tables;
}

}  // namespace rubsweep::apps
