#include "rubsweep/measurement/recording/keyphasor.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rubsweep/core/error.hpp"

namespace rubsweep::recording {

double middle_threshold(std::span<const double> signal) {
  std::vector<double> sorted;
  std::ranges::copy_if(signal, std::back_inserter(sorted), [](double value) { return std::isfinite(value); });
  std::ranges::sort(sorted);
  const std::size_t outside = sorted.size() / 1000;
  if (sorted.empty() || !(sorted[outside] < sorted[sorted.size() - 1 - outside]))
    throw ConfigError("the keyphasor's signal does not change, allowed: one that a mark changes every turn");
  return (sorted[outside] + sorted[sorted.size() - 1 - outside]) / 2;
}

std::vector<double> mark_times_s(std::span<const double> t_s, std::span<const double> signal, Mark mark,
                                 double threshold, double hysteresis) {
  // Above 0 while the mark is before the probe.
  const auto height = [&](std::size_t k) {
    return mark == Mark::bright ? signal[k] - threshold : threshold - signal[k];
  };
  std::vector<double> marks_s;
  bool armed = false, gap = true;
  for (std::size_t k = 0; k < t_s.size(); ++k) {
    const double now = height(k);
    if (!std::isfinite(now)) {
      gap = true;
      continue;
    }
    if (armed && now > 0) {
      armed = false;
      if (!gap) {
        const double before = height(k - 1);
        marks_s.push_back(t_s[k - 1] + (t_s[k] - t_s[k - 1]) * before / (before - now));
      }
    } else if (now <= 0 && now <= -hysteresis) {
      armed = true;
    }
    gap = false;
  }
  return marks_s;
}

}  // namespace rubsweep::recording
