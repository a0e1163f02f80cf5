#include "rubsweep/measurement/diagnose/observed_lines.hpp"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// z = x + iy after each of both was multiplied: conj(z) has the lines conj(A_-k).
MotionLines with_gains(const MotionLines& lines, double x_gain, double y_gain) {
  MotionLines seen = lines;
  for (int k = -lines.last(); k <= lines.last(); ++k)
    seen.at(k) = (x_gain + y_gain) / 2 * lines.at(k) + (x_gain - y_gain) / 2 * std::conj(lines.at(-k));
  return seen;
}

}  // namespace

MotionLines observed(const MotionLines& motion, const Measuring& measuring, RandomStream& random,
                     double& probe_angle_rad) {
  const double size = size_of(motion);
  MotionLines seen = motion;
  for (const OtherLine& line : draw_other_lines(measuring.other_lines, size, random))
    if (std::abs(line.order) * seen.turns <= seen.last()) seen.at(line.order * seen.turns) += line.amplitude;
  const double noise = size * value_at(measuring.noise_share, random.uniform());
  const double x_gain = 1 + measuring.gain_error * random.normal(),
               y_gain = 1 + measuring.gain_error * random.normal();
  probe_angle_rad = 0;
  if (measuring.probes == 1)
    probe_angle_rad = measuring.directions ? measuring.probe_angle_rad : 2 * pi * random.uniform();
  seen.amplitude *= std::polar(1.0, -probe_angle_rad);
  seen = with_gains(seen, x_gain, measuring.probes == 1 ? 0 : y_gain);
  // White noise of n readings leaves noise / sqrt(n) in each line, from x and from y.
  const double of_a_line = noise / std::sqrt(measuring.readings_per_turn * seen.turns);
  MotionLines rustle{seen.turns, Eigen::VectorXcd(seen.amplitude.size())};
  for (Complex& a : rustle.amplitude) {
    const double real = random.normal();
    a = of_a_line * Complex(real, random.normal());
  }
  // Noise of one probe is real, too.
  seen.amplitude += measuring.probes == 1 ? with_gains(rustle, 1, 0).amplitude : rustle.amplitude;
  if (measuring.from_rest) {
    const double x = random.normal(), y = random.normal();
    seen.at(0) += size * Measuring::rest_error * (measuring.probes == 1 ? Complex(x) : Complex(x, y));
  }
  return seen;
}

}  // namespace rubsweep::diagnose
