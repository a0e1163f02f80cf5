#include "rubsweep/report/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/response/bode.hpp"
#include "rubsweep/response/free_decay.hpp"

namespace rubsweep::report {
namespace {

using batch::csv_number;

constexpr std::uint64_t seed = 1;

void add_noise(Eigen::MatrixXd& signal, double noise_m) {
  if (noise_m == 0) return;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, noise_m);
  for (Eigen::Index i = 0; i < signal.cols(); ++i) {
    for (double& value : signal.col(i)) value += noise(random);
  }
}

std::span<const double> column(const Eigen::MatrixXd& signal, Eigen::Index i) {
  return {signal.col(i).data(), static_cast<std::size_t>(signal.rows())};
}

std::string sensors_csv(const integrate::LinearRun& run, const Eigen::MatrixXd& signal) {
  std::string text = "t_s,speed_hz,shaft_angle_rad";
  for (Eigen::Index i = 0; i < signal.cols(); ++i) text += fmt::format(",sensor_{}_m", i);
  text += '\n';
  for (Eigen::Index k = 0; k < signal.rows(); ++k) {
    const double t = static_cast<double>(k) * run.sample_s;
    text += csv_number(t);
    for (const double value : {integrate::shaft_speed_hz(run, t), integrate::shaft_angle_rad(run, t)}) {
      text.append(",").append(csv_number(value));
    }
    for (Eigen::Index i = 0; i < signal.cols(); ++i) text.append(",").append(csv_number(signal(k, i)));
    text += '\n';
  }
  return text;
}

void add(std::string& identification, const char* quantity, Eigen::Index sensor, double value) {
  identification += fmt::format("{},{},{}\n", quantity, sensor, csv_number(value));
}

constexpr const char* identification_header = "quantity,sensor,value\n";

/// A sensor across the kick sees rounding only, or what the noise hides.
std::vector<bool> sees_something(const Eigen::MatrixXd& signal, double noise_m) {
  const double floor_m = std::max(noise_m, 1e-9 * signal.cwiseAbs().maxCoeff());
  std::vector<bool> sees;
  for (Eigen::Index i = 0; i < signal.cols(); ++i)
    sees.push_back(signal.col(i).cwiseAbs().maxCoeff() > floor_m);
  return sees;
}

std::string bode_csv(const std::vector<std::vector<response::BodePoint>>& plots) {
  std::string text = "speed_hz";
  for (std::size_t i = 0; i < plots.size(); ++i)
    text += fmt::format(",sensor_{0}_amplitude_m,sensor_{0}_phase_deg", i);
  text += '\n';
  for (std::size_t k = 0; k < plots.front().size(); ++k) {
    text += csv_number(plots.front()[k].speed_hz);
    for (const auto& plot : plots) {
      text.append(",")
          .append(csv_number(plot[k].amplitude_m))
          .append(",")
          .append(csv_number(plot[k].phase_deg));
    }
    text += '\n';
  }
  return text;
}

}  // namespace

Experiment free_response(const scene::Plan& plan, double duration_s, const Sampling& sampling) {
  const integrate::SensorRows sensors = integrate::sensor_rows(plan);
  const integrate::LinearRun run{.kick = true,
                                 .sample_s = sampling.sample_s,
                                 .samples = static_cast<int>(std::floor(duration_s / sampling.sample_s)) + 1};
  Eigen::MatrixXd signal = integrate::run_linear(plan, run, sensors.rows);
  const std::vector<bool> sees = sees_something(signal, sampling.noise_m);
  add_noise(signal, sampling.noise_m);
  Experiment experiment{.sensors_csv = sensors_csv(run, signal),
                        .bode_csv = {},
                        .identification_csv = identification_header,
                        .summary = {}};
  for (Eigen::Index i = 0; i < signal.cols(); ++i) {
    const double angle = sensors.angle_deg[static_cast<std::size_t>(i)];
    if (!sees[static_cast<std::size_t>(i)]) {
      experiment.summary += fmt::format("sensor {} ({} deg)  does not see the kick\n", i, angle);
      continue;
    }
    const auto later = column(signal, i).subspan(static_cast<std::size_t>(signal.rows() / 4));
    const response::FreeDecay fit = response::fit_free_decay(later, sampling.sample_s);
    add(experiment.identification_csv, "natural_frequency_hz", i, fit.natural_frequency_hz);
    add(experiment.identification_csv, "damping_ratio", i, fit.damping_ratio);
    add(experiment.identification_csv, "misfit", i, fit.misfit);
    experiment.summary +=
        fmt::format("sensor {} ({} deg)  natural frequency {:.5g} Hz, damping ratio {:.4g}, misfit {:.2g}\n",
                    i, angle, fit.natural_frequency_hz, fit.damping_ratio, fit.misfit);
  }
  return experiment;
}

Experiment run_up(const scene::Plan& plan, double from_hz, double to_hz, double rate_hz_per_s,
                  double eccentricity_m, const Sampling& sampling) {
  const integrate::SensorRows sensors = integrate::sensor_rows(plan);
  const double duration_s = (to_hz - from_hz) / rate_hz_per_s;
  const integrate::LinearRun run{.from_hz = from_hz,
                                 .rate_hz_per_s = rate_hz_per_s,
                                 .eccentricity_m = eccentricity_m,
                                 .sample_s = sampling.sample_s,
                                 .samples = static_cast<int>(std::floor(duration_s / sampling.sample_s)) + 1};
  Eigen::MatrixXd signal = integrate::run_linear(plan, run, sensors.rows);
  add_noise(signal, sampling.noise_m);
  std::vector<double> angle, speed;
  for (int k = 0; k < run.samples; ++k) {
    angle.push_back(integrate::shaft_angle_rad(run, k * run.sample_s));
    speed.push_back(integrate::shaft_speed_hz(run, k * run.sample_s));
  }
  Experiment experiment{.sensors_csv = sensors_csv(run, signal),
                        .bode_csv = {},
                        .identification_csv = identification_header,
                        .summary = {}};
  std::vector<std::vector<response::BodePoint>> plots;
  for (Eigen::Index i = 0; i < signal.cols(); ++i) {
    const double direction = sensors.angle_deg[static_cast<std::size_t>(i)];
    plots.push_back(response::bode_plot(column(signal, i), angle, speed, direction, bode_revolutions));
    const double critical = response::critical_speed_hz(plots.back());
    double largest = 0;
    for (const auto& point : plots.back()) largest = std::max(largest, point.amplitude_m);
    add(experiment.identification_csv, "critical_speed_hz", i, critical);
    add(experiment.identification_csv, "largest_amplitude_m", i, largest);
    experiment.summary +=
        fmt::format("sensor {} ({} deg)  critical speed {:.5g} Hz, 1X amplitude there {:.4g} m\n", i,
                    direction, critical, largest);
  }
  experiment.bode_csv = bode_csv(plots);
  return experiment;
}

}  // namespace rubsweep::report
