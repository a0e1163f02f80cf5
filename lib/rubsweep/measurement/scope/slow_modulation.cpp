#include "rubsweep/measurement/scope/slow_modulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/core/numerics/straight_line.hpp"
#include "rubsweep/measurement/scope/repeating_angles.hpp"

namespace rubsweep::scope {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr std::size_t fewest_levelled = 4, periods_a_cosine = 8;
constexpr double most_drift = 0.5;

/// Slow part of some values about their mean.
std::vector<double> slow_part(const std::vector<double>& values) {
  const std::size_t count = values.size();
  std::vector<double> places(count), slow(count);
  for (std::size_t j = 0; j < count; ++j) places[j] = static_cast<double>(j);
  const numerics::StraightLine line = numerics::line_through(places, values);
  for (std::size_t j = 0; j < count; ++j) slow[j] = line(places[j]) - line.value;
  for (std::size_t d = 1; d <= count / periods_a_cosine; ++d) {
    const auto cosine = [&](std::size_t j) {
      return std::cos(pi * static_cast<double>(d) * (static_cast<double>(j) + 0.5) /
                      static_cast<double>(count));
    };
    double sum = 0;
    for (std::size_t j = 0; j < count; ++j) sum += (values[j] - line(places[j])) * cosine(j);
    for (std::size_t j = 0; j < count; ++j) slow[j] += 2 * sum / static_cast<double>(count) * cosine(j);
  }
  return slow;
}

/// Slow part of a line's amplitudes.
struct Slow {
  std::vector<Complex> amplitudes{};
  double square = 0;  ///< mean
};

Slow slow_part_of(const std::vector<Complex>& amplitudes) {
  std::vector<double> real, imaginary;
  for (const Complex a : amplitudes) {
    real.push_back(a.real());
    imaginary.push_back(a.imag());
  }
  real = slow_part(real);
  imaginary = slow_part(imaginary);
  Slow slow;
  for (std::size_t j = 0; j < real.size(); ++j) {
    slow.amplitudes.emplace_back(real[j], imaginary[j]);
    slow.square += std::norm(slow.amplitudes.back()) / static_cast<double>(real.size());
  }
  return slow;
}

Complex mean_of(const std::vector<Complex>& amplitudes) {
  Complex mean = 0;
  for (const Complex a : amplitudes) mean += a / static_cast<double>(amplitudes.size());
  return mean;
}

/// Amplitudes without what comes again after so many of them, but for its mean: the lines of a longer period
/// alias into those of a turn.
std::vector<Complex> without_repetition(const std::vector<Complex>& amplitudes, std::size_t repeats) {
  const Complex mean = mean_of(amplitudes);
  std::vector<Complex> left = amplitudes;
  for (std::size_t first = 0; first < std::min(repeats, left.size()); ++first) {
    Complex sum = 0;
    double count = 0;
    for (std::size_t j = first; j < left.size(); j += repeats, ++count) sum += amplitudes[j];
    for (std::size_t j = first; j < left.size(); j += repeats) left[j] += mean - sum / count;
  }
  return left;
}

/// Adds line `order` of a period with an amplitude that is a straight line between the middles of two
/// periods.
void add_line(const std::vector<Complex>& amplitudes, int order, std::size_t length, std::span<Complex> sum) {
  const double step = 2 * pi * order / static_cast<double>(length),
               most = static_cast<double>(amplitudes.size() - 2);
  for (std::size_t k = 0; k < sum.size(); ++k) {
    const double place = (static_cast<double>(k) + 0.5) / static_cast<double>(length) - 0.5;
    const double before = std::clamp(std::floor(place), 0.0, most), share = place - before;
    const auto j = static_cast<std::size_t>(before);
    sum[k] += ((1 - share) * amplitudes[j] + share * amplitudes[j + 1]) *
              std::polar(1.0, step * static_cast<double>(k % length));
  }
}

}  // namespace

Levelled without_slow_modulation(std::span<const Complex> samples, int samples_per_revolution, int period,
                                 double most_order, double most_modulation, std::size_t repeats) {
  Levelled levelled{.samples = {samples.begin(), samples.end()}};
  const auto length = static_cast<std::size_t>(period * samples_per_revolution);
  const auto whole = std::span(levelled.samples).last(samples.size() / length * length);
  const std::size_t periods = whole.size() / length;
  if (periods < fewest_levelled) return levelled;
  const int last = std::min(static_cast<int>(most_order * period), static_cast<int>(length) / 2 - 1);
  const auto lines = static_cast<std::size_t>(2 * last + 1);
  std::vector<std::vector<Complex>> amplitudes(lines);
  double energy = 0;
  for (std::size_t j = 0; j < periods; ++j) {
    const auto found = lines_of_period(whole.subspan(j * length, length), last);
    for (std::size_t i = 0; i < lines; ++i) {
      amplitudes[i].push_back(found[i]);
      if (i != static_cast<std::size_t>(last)) energy += std::norm(found[i]) / static_cast<double>(periods);
    }
  }
  std::vector<Complex> taken(whole.size());
  const auto centre = static_cast<std::size_t>(last);
  const double most_of_a_line = std::min(2 * most_modulation, 1.0);
  double squares = 0, refused = 0;
  for (std::size_t i = 0; i < lines; ++i) {
    const double bound = i == centre ? most_drift * most_drift * energy
                                     : most_of_a_line * most_of_a_line * std::norm(mean_of(amplitudes[i]));
    const Slow slow = slow_part_of(repeats > 1 ? without_repetition(amplitudes[i], repeats) : amplitudes[i]);
    if (!(slow.square <= bound)) {
      if (i != centre) refused += slow.square;
      continue;
    }
    add_line(slow.amplitudes, static_cast<int>(i) - last, length, taken);
    // A gap voltage that drifts is no motion.
    if (i != centre) squares += slow.square;
  }
  levelled.refused_m = std::sqrt(refused);
  if (!(squares <= most_modulation * most_modulation * energy)) {
    levelled.refused_m = std::sqrt(refused + squares);
    return levelled;
  }
  for (std::size_t k = 0; k < taken.size(); ++k) whole[k] -= taken[k];
  levelled.modulation_m = std::sqrt(squares);
  return levelled;
}

}  // namespace rubsweep::scope
