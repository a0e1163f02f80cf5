#include "rubsweep/core/model/rolling_bearing.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::model {

double strikes_per_revolution(const RollingBearing& bearing, BearingDefect defect) {
  const double size = bearing.ball_diameter_m / bearing.pitch_diameter_m;
  const double g = size * std::cos(bearing.contact_angle_deg * std::numbers::pi / 180);
  switch (defect) {
    case BearingDefect::outer_race: return bearing.balls * (1 - g) / 2;
    case BearingDefect::inner_race: return bearing.balls * (1 + g) / 2;
    case BearingDefect::ball: return (1 - g * g) / size;
    case BearingDefect::cage: break;
  }
  return (1 - g) / 2;
}

}  // namespace rubsweep::model
