#include "rubsweep/analysis/linear/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <span>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/spectral/hermitian.hpp"

namespace rubsweep::linear {
namespace {

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

int samples_in(double duration_s, double sample_s) {
  return static_cast<int>(std::floor(duration_s / sample_s)) + 1;
}

/// Whether each sensor sees a signal: one across the motion sees rounding only, or less than the noise.
std::vector<bool> sees_something(const Eigen::MatrixXd& signal, double noise_m) {
  const double floor_m = std::max(noise_m, 1e-9 * signal.cwiseAbs().maxCoeff());
  std::vector<bool> sees;
  for (Eigen::Index i = 0; i < signal.cols(); ++i)
    sees.push_back(signal.col(i).cwiseAbs().maxCoeff() > floor_m);
  return sees;
}

/// A of every sensor's part Re(A e^{i phi}) that turns with the shaft, samples x sensors.
Eigen::MatrixXcd phasors(const scene::PreparedMachine& machine, LinearRun run, const Eigen::MatrixXd& rows) {
  run.driven = Driven::in_phase;
  const Eigen::MatrixXd in_phase = run_linear(machine, run, rows);
  run.driven = Driven::quarter_behind;
  const Eigen::MatrixXd behind = run_linear(machine, run, rows);
  Eigen::MatrixXcd phasors(in_phase.rows(), in_phase.cols());
  for (Eigen::Index k = 0; k < phasors.rows(); ++k) {
    const double angle_rad = shaft_angle_rad(run, static_cast<double>(k) * run.sample_s);
    for (Eigen::Index i = 0; i < phasors.cols(); ++i)
      phasors(k, i) = std::complex<double>(in_phase(k, i), behind(k, i)) * std::polar(1.0, -angle_rad);
  }
  return phasors;
}

}  // namespace

FreeResponse free_response(const scene::PreparedMachine& machine, double duration_s,
                           const Sampling& sampling) {
  const SensorRows sensors = sensor_rows(machine);
  FreeResponse response{.run = {.kick = true,
                                .sample_s = sampling.sample_s,
                                .samples = samples_in(duration_s, sampling.sample_s)},
                        .signal_m = {},
                        .angle_deg = sensors.angle_deg,
                        .decay = {}};
  response.signal_m = run_linear(machine, response.run, sensors.rows);
  const std::vector<bool> sees = sees_something(response.signal_m, sampling.noise_m);
  add_noise(response.signal_m, sampling.noise_m);
  for (Eigen::Index i = 0; i < response.signal_m.cols(); ++i) {
    response.decay.emplace_back();
    if (!sees[static_cast<std::size_t>(i)]) continue;
    const auto later =
        column(response.signal_m, i).subspan(static_cast<std::size_t>(response.signal_m.rows() / 4));
    response.decay.back() = fit_free_decay(later, sampling.sample_s);
  }
  return response;
}

double lowest_frequency_hz(const scene::PreparedMachine& machine) {
  const auto& system = machine.assembly.system;
  const Eigen::MatrixXd stiffness = (system.stiffness + system.stiffness.transpose()) / 2;
  const Eigen::VectorXd squares = numerics::spectral::generalized_eigenvalues(stiffness, system.mass);
  if (!squares.allFinite()) throw SolverError("lowest frequency: the eigenvalue iteration does not converge");
  return std::sqrt(std::max(squares.minCoeff(), 0.0)) / (2 * std::numbers::pi);
}

RunUp run_up(const scene::PreparedMachine& machine, double from_hz, double to_hz, double rate_hz_per_s,
             double eccentricity_m, const Sampling& sampling) {
  const SensorRows sensors = sensor_rows(machine);
  RunUp run_up{.run = {.from_hz = from_hz,
                       .rate_hz_per_s = rate_hz_per_s,
                       .eccentricity_m = eccentricity_m,
                       .sample_s = sampling.sample_s,
                       .samples = samples_in((to_hz - from_hz) / rate_hz_per_s, sampling.sample_s)},
               .signal_m = {},
               .angle_deg = sensors.angle_deg,
               .bode = {},
               .sees = {},
               .speed_of_largest_1x_hz = {},
               .resonance = {},
               .largest_amplitude_m = {}};
  run_up.signal_m = run_linear(machine, run_up.run, sensors.rows);
  const Eigen::MatrixXcd phasor_m = phasors(machine, run_up.run, sensors.rows);
  // Without noise: the Bode plot finds modes that noise hides in a free response.
  run_up.sees = sees_something(phasor_m.cwiseAbs(), 0);
  Eigen::MatrixXd noise_m = Eigen::MatrixXd::Zero(run_up.signal_m.rows(), run_up.signal_m.cols());
  add_noise(noise_m, sampling.noise_m);
  run_up.signal_m += noise_m;
  std::vector<double> angle_rad, speed_hz;
  for (int k = 0; k < run_up.run.samples; ++k) {
    angle_rad.push_back(shaft_angle_rad(run_up.run, k * run_up.run.sample_s));
    speed_hz.push_back(shaft_speed_hz(run_up.run, k * run_up.run.sample_s));
  }
  for (Eigen::Index i = 0; i < phasor_m.cols(); ++i) {
    const auto sensor = static_cast<std::size_t>(i);
    OneX one = one_x({.phasor_m = {phasor_m.col(i).data(), angle_rad.size()},
                      .noise_m = sampling.noise_m > 0 ? column(noise_m, i) : std::span<const double>{},
                      .shaft_angle_rad = angle_rad,
                      .speed_hz = speed_hz,
                      .sensor_angle_deg = sensors.angle_deg[sensor]},
                     bode_revolutions);
    run_up.speed_of_largest_1x_hz.emplace_back();
    run_up.resonance.emplace_back();
    if (run_up.sees[sensor] && one.speed_of_largest_hz) {
      run_up.speed_of_largest_1x_hz.back() = one.speed_of_largest_hz;
      run_up.resonance.back() = fit_ramp_resonance(one.plot, rate_hz_per_s);
    }
    run_up.largest_amplitude_m.push_back(one.largest_amplitude_m);
    run_up.bode.push_back(std::move(one.plot));
  }
  return run_up;
}

}  // namespace rubsweep::linear
