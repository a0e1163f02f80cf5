#pragma once

#include <vector>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::audit {

/// Result of a turn by time stepping.
struct SteppedTurn {
  std::vector<double> section;  ///< as TurnReport::section
  long stuck = 0;               ///< steps in which dry friction held a contact
  long together = 0;            ///< steps in which it held the slip of two or more at zero
};

/// A revolution from `section` (as TurnReport::section) of a scene without pulses by `steps` equal steps of
/// Moreau and Jean: forces at the middle of a step, friction implicit, as a set at slip zero. Locates no
/// events. The friction of a step is found by trying every set of contacts that stick, and shares no code
/// with the solvers.
SteppedTurn time_stepping_turn(const scene::Scene& scene, const std::vector<double>& section, long steps);

}  // namespace rubsweep::audit
