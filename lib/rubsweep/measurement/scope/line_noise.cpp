#include "rubsweep/measurement/scope/line_noise.hpp"

#include <cstddef>
#include <numbers>
#include <vector>

namespace rubsweep::scope {
namespace {

constexpr double false_alarm = 0.01;
/// False-alarm probability of a suspicious line, which is too small to count as visible.
constexpr double suspicion = 0.2;

/// Whether line k, in a spectrum over `turns` turns, is a multiple of order 1/n.
bool on_comb(int k, int turns, int n) { return static_cast<long>(k) * n % turns == 0; }

/// Standard deviation of each component of a line, and the relative variance of this estimate.
struct Noise {
  double deviation_m = 0, variance = 0;
};

/// Noise from the median of the lines that belong to no period.
Noise noise_of(const Lines& spectrum) {
  std::vector<double> between, all;
  for_lines(spectrum, [&](int k, double amplitude) {
    bool belongs = false;
    for (int n = 1; n <= longest_period_in(spectrum.turns); ++n)
      belongs = belongs || on_comb(k, spectrum.turns, n);
    all.push_back(amplitude / spectrum.noise_at(k));
    if (!belongs) between.push_back(all.back());
  });
  constexpr std::size_t fewest_lines = 16;
  std::vector<double>& lines = between.size() >= fewest_lines ? between : all;
  const auto middle = lines.begin() + static_cast<std::ptrdiff_t>(lines.size() / 2);
  std::ranges::nth_element(lines, middle);
  // The median of a Rayleigh distribution is s sqrt(2 ln 2); its density there is ln 2 / median.
  constexpr double root = 2 * std::numbers::ln2;
  return {*middle / std::sqrt(root), 1 / (root * root * static_cast<double>(lines.size()))};
}

}  // namespace

Threshold threshold_of(const Lines& spectrum) {
  const Noise noise = noise_of(spectrum);
  Threshold threshold{.noise_m = noise.deviation_m};
  int count = 0;
  for_lines(spectrum, [&](int, double amplitude) {
    ++count;
    threshold.largest_m = std::max(threshold.largest_m, amplitude);
  });
  // The largest of `count` noise lines exceeds s sqrt(2 ln(count / p)) with probability p. As s is an
  // estimate with relative variance v, the mean of exp(-t^2 s^2 / 2) requires t^2 / (1 + t^2 v) in place of
  // t^2.
  const auto reached = [&](double probability) {
    constexpr double most = 0.75;
    const double square = 2 * std::log(count / probability);
    return noise.deviation_m * std::sqrt(square / (1 - std::min(square * noise.variance, most)));
  };
  threshold.floor_m = spectrum.least_share * threshold.largest_m;
  threshold.suspicious_m = reached(suspicion);
  threshold.seen_m = reached(false_alarm);
  return threshold;
}

Beside highest_beside(const Lines& spectrum, int n, int period) {
  Beside highest;
  for_lines(spectrum, [&](int k, double amplitude) {
    if (on_comb(k, spectrum.turns, n) || (period != 0 && !on_comb(k, spectrum.turns, period))) return;
    const double noise = spectrum.noise_at(k);
    if (amplitude * highest.noise > highest.amplitude_m * noise) highest = {amplitude, noise};
  });
  return highest;
}

bool is_visible_beside(const Lines& spectrum, int n, const Threshold& threshold) {
  bool visible = false;
  for_lines(spectrum, [&](int k, double amplitude) {
    visible =
        visible || (!on_comb(k, spectrum.turns, n) && amplitude > threshold.visible_m(spectrum.noise_at(k)));
  });
  return visible;
}

}  // namespace rubsweep::scope
