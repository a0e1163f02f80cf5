#include "rubsweep/analysis/design/largest_over_speed.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::design {

std::vector<double> response_speeds(const SpeedRange& range,
                                    std::span<const linear::CriticalSpeed> critical) {
  constexpr int even = 401;
  std::vector<double> speeds = batch::evenly_spaced(range.from_hz, range.to_hz, even);
  for (const linear::CriticalSpeed& one : critical) {
    const double half_width_hz = std::abs(one.damping_ratio) * one.speed_hz;
    for (const double widths : {-8.0, -4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 4.0, 8.0}) {
      const double speed_hz = one.speed_hz + widths * half_width_hz;
      if (range.contains(speed_hz)) speeds.push_back(speed_hz);
    }
  }
  std::ranges::sort(speeds);
  speeds.erase(std::unique(speeds.begin(), speeds.end()), speeds.end());
  return speeds;
}

Largest largest_over_speed(std::span<const double> speeds_hz, const std::function<double(double)>& value) {
  constexpr int bits = 40;
  const auto negative = [&](double speed_hz) {
    const double found = value(speed_hz);
    return std::isfinite(found) ? -found : -std::numeric_limits<double>::infinity();
  };
  std::vector<double> samples;
  for (const double speed_hz : speeds_hz) samples.push_back(-negative(speed_hz));
  Largest largest{speeds_hz.front(), samples.front()};
  const auto consider = [&](double speed_hz, double found) {
    if (found > largest.value) largest = {speed_hz, found};
  };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    consider(speeds_hz[k], samples[k]);
    const bool inside = k > 0 && k + 1 < samples.size();
    if (!inside || samples[k] < samples[k - 1] || samples[k] < samples[k + 1] || std::isinf(samples[k]))
      continue;
    std::uintmax_t iterations = 100;
    const auto [speed_hz, least] =
        boost::math::tools::brent_find_minima(negative, speeds_hz[k - 1], speeds_hz[k + 1], bits, iterations);
    consider(speed_hz, -least);
  }
  return largest;
}

}  // namespace rubsweep::design
