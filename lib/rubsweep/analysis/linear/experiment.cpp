#include "rubsweep/analysis/linear/experiment.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

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

/// Whether each sensor measures a signal. A sensor perpendicular to the motion reads only rounding errors, or
/// less than the noise.
std::vector<bool> sees_something(const Eigen::MatrixXd& signal, double noise_m) {
  const double floor_m = std::max(noise_m, 1e-9 * signal.cwiseAbs().maxCoeff());
  std::vector<bool> sees;
  for (Eigen::Index i = 0; i < signal.cols(); ++i)
    sees.push_back(signal.col(i).cwiseAbs().maxCoeff() > floor_m);
  return sees;
}

/// Phasors A of each sensor's 1X part Re(A e^{i phi}), samples x sensors.
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

using std::numbers::pi;
using Samples = Eigen::Map<const Eigen::VectorXd>;

/// Parameters of a decay: decay rate and damped angular frequency, per sample; then cosine, sine, offset.
using Parameters = Eigen::Matrix<double, 5, 1>;

/// Parameters with the best cosine, sine and offset for given decay and frequency.
Parameters complete(const Samples& x, double decay, double frequency) {
  Eigen::MatrixX3d base(x.size(), 3);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const auto t = static_cast<double>(k);
    const std::complex<double> z = std::polar(std::exp(-decay * t), frequency * t);
    base.row(k) << z.real(), z.imag(), 1;
  }
  const Eigen::Vector3d linear = base.colPivHouseholderQr().solve(x);
  return {decay, frequency, linear(0), linear(1), linear(2)};
}

/// Residual of the fit, and its Jacobian if `jacobian` is not null.
Eigen::VectorXd residual(const Samples& x, const Parameters& p,
                         Eigen::Matrix<double, Eigen::Dynamic, 5>* jacobian) {
  Eigen::VectorXd r(x.size());
  if (jacobian != nullptr) jacobian->resize(x.size(), 5);
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    const auto t = static_cast<double>(k);
    const double c = std::exp(-p(0) * t) * std::cos(p(1) * t), s = std::exp(-p(0) * t) * std::sin(p(1) * t);
    r(k) = p(2) * c + p(3) * s + p(4) - x(k);
    if (jacobian != nullptr)
      jacobian->row(k) << -t * (p(2) * c + p(3) * s), t * (p(3) * c - p(2) * s), c, s, 1;
  }
  return r;
}

/// Angular frequency per sample of the largest spectral line of the signal without its mean. Zeros are
/// appended, three times as many as there are samples, so that the frequency grid is four times finer.
double strongest_frequency(const Samples& x) {
  const auto length = static_cast<std::size_t>(4 * x.size());
  std::vector<std::complex<double>> padded(length);
  std::ranges::copy(x.array() - x.mean(), padded.begin());
  response::spectrum::SpectrumWorkspace workspace;
  const auto spectrum = response::spectrum::full_spectrum(padded, 1, workspace);
  const int lines = spectrum.last_line();
  int strongest = 2;
  for (int line = 2; line <= lines; ++line)
    if (spectrum.amplitude(line) > spectrum.amplitude(strongest)) strongest = line;
  return 2 * pi * strongest / static_cast<double>(length);
}

/// Levenberg-Marquardt iteration. Eigen's unsupported version finds the same minimum within 1e-8, but would
/// change the last printed digits of identification.csv.
Parameters refine(const Samples& x, Parameters p) {
  double error = residual(x, p, nullptr).squaredNorm(), damping = 1e-3;
  constexpr int most_iterations = 200;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    Eigen::Matrix<double, Eigen::Dynamic, 5> jacobian;
    const Eigen::VectorXd r = residual(x, p, &jacobian);
    Eigen::Matrix<double, 5, 5> normal = jacobian.transpose() * jacobian;
    const Parameters gradient = jacobian.transpose() * r;
    normal.diagonal() *= 1 + damping;
    const Parameters trial = p - normal.ldlt().solve(gradient);
    const double trial_error = residual(x, trial, nullptr).squaredNorm();
    if (trial_error < error) {
      const bool settled = error - trial_error <= 1e-15 * error;
      p = trial;
      error = trial_error;
      damping /= 10;
      if (settled) return p;
    } else if ((damping *= 10) > 1e12) {
      return p;
    }
  }
  throw SolverError(fmt::format("free response: the fit has not settled after {} steps", most_iterations));
}

}  // namespace

FreeResponse free_response(const scene::PreparedMachine& machine, double duration_s,
                           const Sampling& sampling) {
  const SensorRows sensors = sensor_rows(machine);
  FreeResponse response{.run = {.kick = true,
                                .sample_s = sampling.sample_s,
                                .samples = samples_in(duration_s, sampling.sample_s)},
                        .angle_deg = sensors.angle_deg};
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
               .angle_deg = sensors.angle_deg};
  run_up.signal_m = run_linear(machine, run_up.run, sensors.rows);
  const Eigen::MatrixXcd phasor_m = phasors(machine, run_up.run, sensors.rows);
  // Noise is ignored here, because the Bode plot finds modes that noise hides in a free response.
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

FreeDecay fit_free_decay(std::span<const double> displacement_m, double sample_s) {
  const Samples x(displacement_m.data(), static_cast<Eigen::Index>(displacement_m.size()));
  if (x.size() < 16) throw ConfigError("free response: too short, allowed: 16 samples or more");
  const double energy = (x.array() - x.mean()).square().sum();
  if (!(energy > 0)) throw ConfigError("free response: the signal does not move");
  const double frequency = strongest_frequency(x);
  Parameters best = complete(x, 0, frequency);
  double least = residual(x, best, nullptr).squaredNorm();
  for (double ratio = 1e-3; ratio < 0.5; ratio *= 1.5) {
    const Parameters trial = complete(x, ratio * frequency, frequency);
    const double error = residual(x, trial, nullptr).squaredNorm();
    if (error < least) {
      best = trial;
      least = error;
    }
  }
  best = refine(x, best);
  const double w = std::hypot(best(0), best(1));
  return {.natural_frequency_hz = w / (2 * pi * sample_s),
          .damping_ratio = best(0) / w,
          .amplitude_m = std::hypot(best(2), best(3)),
          .misfit = std::sqrt(residual(x, best, nullptr).squaredNorm() / energy)};
}

}  // namespace rubsweep::linear
