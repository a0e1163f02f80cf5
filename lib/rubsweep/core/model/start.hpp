#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Position and velocity of a body. A number that is not given keeps its value on the quiet whirl, or at rest
/// if the quiet whirl reaches a wall.
struct BodyState {
  std::optional<double> x_m{}, y_m{};  ///< displacement from the unloaded position
  std::optional<double> vx_m_per_s{}, vy_m_per_s{};

  static void visit_fields(auto& self, auto&& visit) {
    constexpr Range displacement{.low = -1e2, .high = 1e2}, velocity{.low = -1e6, .high = 1e6};
    visit("x_m", self.x_m,
          newer_key(displacement, "displacement in x from the unloaded position", "(quiet whirl)"));
    visit("y_m", self.y_m,
          newer_key(displacement, "displacement in y from the unloaded position", "(quiet whirl)"));
    visit("vx_m_per_s", self.vx_m_per_s, newer_key(velocity, "velocity in x", "(quiet whirl)"));
    visit("vy_m_per_s", self.vy_m_per_s, newer_key(velocity, "velocity in y", "(quiet whirl)"));
  }
};

/// State in which a run begins; t = 0 is the instant of smallest gap at the first stop.
struct Start {
  BodyState rotor{};
  std::vector<std::optional<BodyState>> casings{};  ///< casings of the stops; missing: none given
  /// True: the structure is at rest in its unloaded position, whatever is given above. The mark of the shaft
  /// points along +x at t = 0, and all forces act from then on.
  bool at_rest = false;
};

/// Whether a start is given and it is the one at rest.
inline bool begins_at_rest(const std::optional<Start>& start) { return start && start->at_rest; }

}  // namespace rubsweep::model
