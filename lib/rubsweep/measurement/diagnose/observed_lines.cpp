#include "rubsweep/measurement/diagnose/observed_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// A random share between the smallest one and `largest`, uniform in its logarithm.
double share(double largest, RandomStream& random) {
  const double unit = random.uniform();
  if (largest <= OtherLines::smallest_share) return largest * unit;
  return OtherLines::smallest_share * std::pow(largest / OtherLines::smallest_share, unit);
}

void add_line(std::span<Complex> samples, int order, Complex amplitude) {
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto step = static_cast<double>(k % samples_per_revolution);
    samples[k] += amplitude * std::polar(1.0, 2 * pi * order * step / samples_per_revolution);
  }
}

/// Lines after x and y were multiplied by their gains; the lines of conj(z) are conj(A_-k).
MotionLines with_gains(const MotionLines& lines, double x_gain, double y_gain) {
  MotionLines seen = lines;
  for (int k = -lines.last(); k <= lines.last(); ++k)
    seen.at(k) = (x_gain + y_gain) / 2 * lines.at(k) + (x_gain - y_gain) / 2 * std::conj(lines.at(-k));
  return seen;
}

/// A line in the spectrum that no rub caused.
struct OtherLine {
  int order = 0;
  Complex amplitude = 0;  ///< amplitude in the unit of the motion
};

/// Draws lines at -1X, 2X, -2X, 3X and -3X for a motion of this size.
std::array<OtherLine, 5> draw_other_lines(const OtherLines& lines, double size, RandomStream& random) {
  std::array<OtherLine, 5> drawn{{{-1}, {2}, {-2}, {3}, {-3}}};
  for (OtherLine& line : drawn) {
    const double largest = line.order == -1            ? lines.backward_1x
                           : std::abs(line.order) == 2 ? lines.order_2
                                                       : lines.order_3;
    const double amplitude = size * share(largest, random);
    line.amplitude = std::polar(amplitude, 2 * pi * random.uniform());
  }
  return drawn;
}

/// Adds a vibration that decays: at the natural frequency, or, in half of the cases, at any order. It is an
/// ellipse of any form. Its amplitude is uniform in the logarithm, down to a thousandth of the largest.
void add_free_vibration(const Measuring& measuring, double size, RandomStream& random, MotionLines& seen) {
  constexpr double decades = 3, uncertainty = 0.02, slowest = 0.1, fastest = 5, most_decay = 3;
  const double amplitude = size * measuring.free_vibration * std::pow(10, -decades * random.uniform());
  const bool natural = measuring.natural_order > 0 && random.uniform() < 0.5;
  const double unit = random.uniform(),
               order = natural ? measuring.natural_order * (1 + uncertainty * (2 * unit - 1))
                               : slowest * std::pow(fastest / slowest, unit),
               form = 2 * pi * random.uniform(), decay = most_decay * (1 - random.uniform());
  for (const double side : {order, -order}) {
    const Complex start =
        std::polar(amplitude * (side > 0 ? std::cos(form) : std::sin(form)), 2 * pi * random.uniform());
    const Complex rate(-decay, 2 * pi * side * seen.turns);  // per recording
    const Complex rise = start * (std::exp(rate) - 1.0);
    // A line is the mean of start exp((rate - 2 pi i k) s) over s from 0 to 1.
    for (int k = -seen.last(); k <= seen.last(); ++k) seen.at(k) += rise / (rate - Complex(0, 2 * pi * k));
  }
}

}  // namespace

MotionLines lines_of(std::span<const std::complex<double>> samples, int turns, double largest_order,
                     response::spectrum::SpectrumWorkspace& workspace) {
  const int last = static_cast<int>(largest_order * turns), count = static_cast<int>(samples.size());
  if (turns < 1 || 2 * last >= count) throw SolverError("too few samples for lines of that order");
  const auto transformed = response::spectrum::transform(samples, workspace);
  MotionLines lines{turns, Eigen::VectorXcd(2 * last + 1)};
  for (int k = -last; k <= last; ++k)
    lines.at(k) = transformed[static_cast<std::size_t>(k < 0 ? k + count : k)] / static_cast<double>(count);
  return lines;
}

MotionLines up_to(const MotionLines& lines, double largest_order) {
  const int last = std::min(lines.last(), static_cast<int>(largest_order * lines.turns));
  return {lines.turns, lines.amplitude.segment(lines.last() - last, 2 * last + 1)};
}

Eigen::VectorXcd waveform_of(const MotionLines& lines, int samples_per_turn,
                             response::spectrum::SpectrumWorkspace& workspace) {
  const int count = samples_per_turn * lines.turns, last = lines.last();
  if (2 * last >= count) throw SolverError("too few samples for these lines");
  // The inverse transform is the conjugate of the transform of the conjugates.
  std::vector<std::complex<double>> conjugates(static_cast<std::size_t>(count));
  for (int k = -last; k <= last; ++k)
    if (k != 0) conjugates[static_cast<std::size_t>(k < 0 ? k + count : k)] = std::conj(lines.at(k));
  const auto transformed = response::spectrum::transform(conjugates, workspace);
  return Eigen::Map<const Eigen::VectorXcd>(transformed.data(), count).conjugate();
}

double size_of(const MotionLines& lines) {
  return std::sqrt(std::max(0.0, lines.amplitude.squaredNorm() - std::norm(lines.at(0))));
}

void add_other_lines(std::span<Complex> samples, const OtherLines& lines, double size, RandomStream& random) {
  for (const OtherLine& line : draw_other_lines(lines, size, random))
    add_line(samples, line.order, line.amplitude);
}

double size_of(std::span<const Complex> samples) {
  Complex mean = 0;
  for (const Complex z : samples) mean += z;
  mean /= static_cast<double>(samples.size());
  double sum = 0;
  for (const Complex z : samples) sum += std::norm(z - mean);
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

MotionLines observed(const MotionLines& motion, const Measuring& measuring, RandomStream& random,
                     double& probe_angle_rad, double usual_size_m) {
  const double size = std::max(size_of(motion), usual_size_m);
  MotionLines seen = motion;
  for (const OtherLine& line : draw_other_lines(measuring.other_lines, size, random))
    if (std::abs(line.order) * seen.turns <= seen.last()) seen.at(line.order * seen.turns) += line.amplitude;
  add_free_vibration(measuring, size, random, seen);
  const double noise = size * value_at(measuring.noise_share, random.uniform());
  const double x_gain = 1 + measuring.gain_error * random.normal(),
               y_gain = 1 + measuring.gain_error * random.normal();
  probe_angle_rad = 0;
  if (measuring.probes == 1)
    probe_angle_rad = measuring.directions ? measuring.probe_angle_rad : 2 * pi * random.uniform();
  seen.amplitude *= std::polar(1.0, -probe_angle_rad);
  seen = with_gains(seen, x_gain, measuring.probes == 1 ? 0 : y_gain);
  // White noise of n readings leaves noise / sqrt(n) in each line, from x and from y alike.
  const double of_a_line = noise / std::sqrt(measuring.readings_per_turn * seen.turns);
  MotionLines rustle{seen.turns, Eigen::VectorXcd(seen.amplitude.size())};
  for (Complex& a : rustle.amplitude) {
    const double real = random.normal();
    a = of_a_line * Complex(real, random.normal());
  }
  // With one probe the noise is real, like the signal.
  seen.amplitude += measuring.probes == 1 ? with_gains(rustle, 1, 0).amplitude : rustle.amplitude;
  if (measuring.from_rest) {
    const double x = random.normal(), y = random.normal();
    seen.at(0) += size * Measuring::rest_error * (measuring.probes == 1 ? Complex(x) : Complex(x, y));
  }
  return seen;
}

}  // namespace rubsweep::diagnose
