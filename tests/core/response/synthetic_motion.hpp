#pragma once

#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

namespace rubsweep::response::testing {

using Complex = std::complex<double>;

/// exp(2 pi i order turn). Whole turns of the phase are removed first, so that late samples are as accurate
/// as early ones.
inline Complex phasor(double order, double turn) {
  const double phase = order * turn;
  return std::polar(1.0, 2 * std::numbers::pi * (phase - std::floor(phase)));
}

/// One line of a motion: amplitude times phasor(numerator / denominator, turn), with exact phases at the
/// samples.
struct Line {
  int numerator = 1;
  int denominator = 1;
  Complex amplitude = 1;
};

/// Samples of a sum of lines: `per_turn` samples in each of `turns` turns.
inline std::vector<Complex> sample(const std::vector<Line>& lines, int turns, int per_turn) {
  std::vector<Complex> z(static_cast<std::size_t>(turns * per_turn));
  for (std::size_t j = 0; j < z.size(); ++j) {
    for (const Line& line : lines) {
      const long period = static_cast<long>(line.denominator) * per_turn;
      const long step = (static_cast<long>(line.numerator) * static_cast<long>(j)) % period;
      z[j] += line.amplitude * phasor(static_cast<double>(step) / static_cast<double>(period), 1);
    }
  }
  return z;
}

/// Samples of any function z(turn).
inline std::vector<Complex> sample(const std::function<Complex(double)>& z, double first_turn, int turns,
                                   int per_turn) {
  std::vector<Complex> samples(static_cast<std::size_t>(turns * per_turn));
  for (std::size_t j = 0; j < samples.size(); ++j) {
    samples[j] = z(first_turn + static_cast<double>(j) / per_turn);
  }
  return samples;
}

/// Section rows (x, y, x', y') / scale of z(turn) at whole turns. Velocities, per radian of shaft angle, come
/// from a central difference whose error is negligible.
inline std::vector<double> section(const std::function<Complex(double)>& z, double first_turn, int turns,
                                   double scale) {
  constexpr double step = 1e-4;
  std::vector<double> rows;
  for (int k = 0; k <= turns; ++k) {
    const double turn = first_turn + k;
    const Complex velocity = (z(turn + step) - z(turn - step)) / (4 * std::numbers::pi * step);
    for (const double value : {z(turn).real(), z(turn).imag(), velocity.real(), velocity.imag()}) {
      rows.push_back(value / scale);
    }
  }
  return rows;
}

}  // namespace rubsweep::response::testing
