#pragma once

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Damaged part of a rolling bearing.
enum class BearingDefect { outer_race, inner_race, ball, cage };

/// Rolling bearing whose outer race is fixed and whose inner race turns with the shaft.
struct RollingBearing {
  double pitch_diameter_m = required;
  double ball_diameter_m = required;
  double balls = required;
  double contact_angle_deg = 0;

  static constexpr double most_balls = 1000;

  static void visit_fields(auto& self, auto&& visit) {
    visit("pitch_diameter_m", self.pitch_diameter_m,
          key(positive, "diameter of the circle of the balls' centres"));
    visit("ball_diameter_m", self.ball_diameter_m, key(positive, "diameter of a ball"));
    visit("balls", self.balls, key(Range{.low = 1, .high = most_balls}, "number of balls"));
    visit("contact_angle_deg", self.contact_angle_deg,
          key(Range{.low = 0, .high = 90, .high_open = true}, "contact angle"));
  }
};

/// Number of strikes of a defect per revolution of the shaft, for rolling without slip. With n balls and g =
/// ball diameter / pitch diameter times the cosine of the contact angle: n (1 - g) / 2 on the outer race, n
/// (1 + g) / 2 on the inner race, twice per turn of the ball about itself, and once per turn of the cage, (1
/// - g) / 2 (Harris, Rolling Bearing Analysis, 4th edition, 2001, section 25). Needs ball_diameter_m <
/// pitch_diameter_m.
double strikes_per_revolution(const RollingBearing& bearing, BearingDefect defect);

}  // namespace rubsweep::model
