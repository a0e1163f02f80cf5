#include "rubsweep/analysis/design/separation.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace rubsweep::design {
namespace {

/// Samples of a response, and the function that computes it between them.
struct Sampled {
  std::span<const double> speeds_hz;
  const std::function<double(double)>& amplitude;
  std::vector<double> values;
};

/// Speed at which the response first falls to the level, on one side (`step` -1 or 1) of the peak near sample
/// `at`. Empty where the range ends first, or where another peak is higher.
std::optional<double> falls_to(const Sampled& sampled, const Resonance& peak, std::size_t at, int step) {
  const double level = peak.amplitude / std::numbers::sqrt2;
  double inner_hz = peak.speed_hz, inner = peak.amplitude;
  for (std::size_t k = at;;) {
    const bool last = step < 0 ? k == 0 : k + 1 == sampled.values.size();
    if (last) return std::nullopt;
    k = step < 0 ? k - 1 : k + 1;
    const double outer_hz = sampled.speeds_hz[k], outer = sampled.values[k];
    if (outer > peak.amplitude) return std::nullopt;
    if (outer < level) {
      const auto excess = [&](double hz) { return sampled.amplitude(hz) - level; };
      std::uintmax_t iterations = 100;
      const auto bracket = boost::math::tools::toms748_solve(
          excess, std::min(inner_hz, outer_hz), std::max(inner_hz, outer_hz),
          (step < 0 ? outer : inner) - level, (step < 0 ? inner : outer) - level,
          boost::math::tools::eps_tolerance<double>(44), iterations);
      return bracket.first + (bracket.second - bracket.first) / 2;
    }
    inner_hz = outer_hz;
    inner = outer;
  }
}

/// Speed of a peak that is nearly found, by the symmetric difference of values beside it: an extremum is
/// flat, so that the values alone give half of the digits.
double centred(const std::function<double(double)>& amplitude, double speed_hz) {
  constexpr double beside = 3e-5;
  constexpr int steps = 2;
  for (int k = 0; k < steps; ++k) {
    const double low = amplitude((1 - beside) * speed_hz), high = amplitude((1 + beside) * speed_hz),
                 bend = high - 2 * amplitude(speed_hz) + low, step = (low - high) / (2 * bend);
    if (!(bend < 0) || !(std::abs(step) < 1)) return speed_hz;
    speed_hz *= 1 + beside * step;
  }
  return speed_hz;
}

void amplify(const Sampled& sampled, std::size_t at, Resonance& peak) {
  const auto low = falls_to(sampled, peak, at, -1), high = falls_to(sampled, peak, at, 1);
  if (low && high) {
    peak.amplification = peak.speed_hz / (*high - *low);
  } else if (low || high) {
    peak.amplification = peak.speed_hz / (2 * std::abs(peak.speed_hz - (low ? *low : *high)));
  } else {
    peak.amplification_below = peak.speed_hz / (sampled.speeds_hz.back() - sampled.speeds_hz.front());
  }
}

}  // namespace

std::vector<Resonance> resonances(std::span<const double> speeds_hz,
                                  const std::function<double(double)>& amplitude) {
  constexpr int bits = 40;
  constexpr double undamped = std::numeric_limits<double>::max();
  const std::function<double(double)> finite = [&](double hz) {
    const double value = amplitude(hz);
    return std::isfinite(value) ? value : undamped;
  };
  // Between samples at nearly the same speed, differences of the response are rounding.
  constexpr double same_speed = 1e-9;
  std::vector<double> apart_hz;
  for (const double hz : speeds_hz)
    if (apart_hz.empty() || hz > (1 + same_speed) * apart_hz.back()) apart_hz.push_back(hz);
  speeds_hz = apart_hz;
  Sampled sampled{speeds_hz, finite, {}};
  for (const double hz : speeds_hz) sampled.values.push_back(finite(hz));
  std::vector<Resonance> found;
  const std::vector<double>& values = sampled.values;
  for (std::size_t k = 1; k + 1 < values.size(); ++k) {
    if (!(values[k] > values[k - 1] && values[k] >= values[k + 1])) continue;
    std::uintmax_t iterations = 100;
    const auto [near_hz, negative] = boost::math::tools::brent_find_minima(
        [&](double hz) { return -finite(hz); }, speeds_hz[k - 1], speeds_hz[k + 1], bits, iterations);
    Resonance peak{near_hz, -negative, {}, 0};
    if (peak.amplitude < undamped) peak.speed_hz = centred(finite, near_hz);
    peak.amplitude = std::max(peak.amplitude, finite(peak.speed_hz));
    amplify(sampled, k, peak);
    found.push_back(peak);
  }
  return found;
}

double required_separation(double amplification, bool above) {
  if (amplification < critically_damped) return 0;
  const double share = 0.17 * (1 - 1 / (amplification - 1.5));
  return above ? std::min(0.26, 0.1 + share) : std::min(largest_separation_below, share);
}

double separation(const SpeedRange& operating, double speed_hz) {
  return std::max((operating.from_hz - speed_hz) / operating.from_hz,
                  (speed_hz - operating.to_hz) / operating.to_hz);
}

}  // namespace rubsweep::design
