#include "rubsweep/design/vibration_limit.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/error.hpp"
#include "rubsweep/model/balance.hpp"
#include "rubsweep/model/rpm.hpp"

namespace rubsweep::design {

double vibration_limit_m(double max_continuous_hz) {
  constexpr double slow_rotor_m = 25.4e-6, fastest_slow_rpm = 12000;
  return std::min(slow_rotor_m,
                  slow_rotor_m * std::sqrt(fastest_slow_rpm / (model::rpm_per_hz * max_continuous_hz)));
}

double analysis_eccentricity_m(const model::Machine& machine, double max_continuous_hz) {
  constexpr double residual_g_mm_rpm_per_kg = 6350, times_residual = 4;
  const double g_mm_per_metre = model::g_mm_per_metre(machine);
  if (!(g_mm_per_metre > 0)) {
    throw ConfigError(
        "rotor.discs: no disc stands off the axis, so that there is no unbalance to respond to, allowed: at "
        "least one eccentricity_ratio that is not 0");
  }
  return times_residual * residual_g_mm_rpm_per_kg * model::rotor_mass_kg(machine) /
         (model::rpm_per_hz * max_continuous_hz) / g_mm_per_metre;
}

double scale_factor(double limit_m, double response_m) {
  if (response_m * largest_scale_factor <= limit_m) return largest_scale_factor;
  return std::max(limit_m / response_m, smallest_scale_factor);
}

}  // namespace rubsweep::design
