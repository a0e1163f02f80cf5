#include "rubsweep/measurement/diagnose/other_lines.hpp"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// A share between the smallest one and `largest`, its logarithm drawn evenly.
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

}  // namespace

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

}  // namespace rubsweep::diagnose
