#pragma once

#include <cmath>

namespace rubsweep::contact {

/// Displacement d and velocity v of the rotor relative to the casing at one contact, scaled, in the contact's
/// two fixed directions: normal and tangent of a flat wall, x and y in an annular stop.
struct RelativeMotion {
  double d1 = 0, d2 = 0;
  double v1 = 0, v2 = 0;
};

/// Frame at the contact seen from the wall, with the normal n = (cosine, sine) in the fixed directions and
/// the tangent t = (-sine, cosine).
struct ContactFrame {
  double cosine = 1, sine = 0;
  /// 1 / |d|: how fast the normal turns with a tangential displacement; 0 for a flat wall.
  double curvature = 0;
  double penetration = 0;
  double closing_speed = 0;
  double sliding_speed = 0;  ///< d' . t
};

inline ContactFrame flat_frame(const RelativeMotion& m, double clearance) {
  return {1, 0, 0, m.d1 - clearance, m.v1, m.v2};
}

/// In the very centre, where an annular stop has no normal, the first direction is taken for it: nothing
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

}  // namespace rubsweep::contact
