#include "rubsweep/analysis/linear/free_decay.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Samples = Eigen::Map<const Eigen::VectorXd>;

/// Parameters: decay rate, damped circular frequency, both per sample; then cosine, sine, offset.
using Parameters = Eigen::Matrix<double, 5, 1>;

/// Best linear part for given decay and frequency.
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

/// Residual and, where asked for, its Jacobian.
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

/// Circular frequency per sample of the largest line of the signal about its mean, on a grid four times finer
/// than the signal resolves: zeros follow the signal for three times its length.
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

/// Levenberg and Marquardt's descent. Eigen's unsupported one comes to the same minimum within 1e-8, which
/// moves the last digits that identification.csv prints; ours keeps them.
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
