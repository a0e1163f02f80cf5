#pragma once

#include <optional>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Half-sine force pulse on the rotor, F(t) = force_n sin(pi t / duration_s) for 0 <= t <= duration_s.
/// t = 0 is the instant of smallest gap at the first stop, or the instant at which the shaft has turned on by
/// phase_deg from there. By default the pulse points at that stop's wall.
struct Kick {
  double force_n = required;
  double duration_s = required;
  std::optional<double> angle_deg;  ///< direction, from +x towards +y; empty: towards the first stop's wall
  /// Position of the force along the shaft of a rotor kit; empty: at the first stop.
  std::optional<double> position_m = std::nullopt;
  std::optional<double> phase_deg = std::nullopt;  ///< empty: 0

  static void visit_fields(auto& self, auto&& visit) {
    visit("force_n", self.force_n, key(not_negative, "largest force of the half-sine pulse"));
    visit("duration_s", self.duration_s, key(positive, "length of the pulse"));
    visit("angle_deg", self.angle_deg,
          key(any_finite, "direction, from +x towards +y", "(wall of the first stop)"));
    visit("phase_deg", self.phase_deg,
          key(any_finite, "how far the shaft has turned on from the smallest gap when it comes", "0"));
  }
};

}  // namespace rubsweep::model
