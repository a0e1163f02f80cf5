#include "rubsweep/diagnose/free_decay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubsweep::diagnose {

int turns_to_decay(double natural_frequency_hz, double damping_ratio, double speed_hz, double left) {
  constexpr double most = 1e6;
  const double turns =
      -std::log(left) * speed_hz / (2 * std::numbers::pi * damping_ratio * natural_frequency_hz);
  return static_cast<int>(std::ceil(std::min(turns, most)));
}

}  // namespace rubsweep::diagnose
