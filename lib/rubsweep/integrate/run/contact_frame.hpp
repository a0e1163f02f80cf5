#pragma once

#include <cmath>

namespace rubsweep::integrate::run {

/// Relative displacement and velocity of rotor and casing at one contact, in its two fixed directions,
/// scaled.
struct RelativeMotion {
  double d1 = 0, d2 = 0;
  double v1 = 0, v2 = 0;
};

/// The same seen from the wall: normal n = (cosine, sine) in the fixed directions, tangent t = (-sine,
/// cosine).
struct ContactFrame {
  double cosine = 1, sine = 0;
  double curvature =
      0;  ///< 1 / |d|: how fast the normal turns with a tangential displacement; 0 for a flat wall
  double penetration = 0;
  double closing_speed = 0;
  double sliding_speed = 0;  ///< d' . t
};

inline ContactFrame flat_frame(const RelativeMotion& m, double clearance) {
  return {1, 0, 0, m.d1 - clearance, m.v1, m.v2};
}

/// In the very centre, where an annular stop has no normal, that of the first direction is taken: nothing
/// touches there.
inline ContactFrame annular_frame(const RelativeMotion& m, double clearance) {
  const double distance = std::sqrt(m.d1 * m.d1 + m.d2 * m.d2);
  if (distance == 0) return {1, 0, 0, -clearance, m.v1, m.v2};
  const double cosine = m.d1 / distance, sine = m.d2 / distance;
  return {cosine,
          sine,
          1 / distance,
          distance - clearance,
          cosine * m.v1 + sine * m.v2,
          cosine * m.v2 - sine * m.v1};
}

}  // namespace rubsweep::integrate::run
