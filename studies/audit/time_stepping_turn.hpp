#pragma once

#include <vector>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::audit {

/// Result of a turn by time stepping.
struct SteppedTurn {
  std::vector<double> section;  ///< like TurnReport::section
  long stuck = 0;               ///< steps in which dry friction held a contact
  long together = 0;            ///< steps in which two or more slips were held at zero
};

/// One revolution from `section` (like TurnReport::section) of a scene without pulses by `steps` equal
/// Moreau-Jean steps: forces at mid-step, and implicit friction that is set-valued at zero slip. No events
/// are located. The friction of a step is found by trying every combination of sticking contacts, and shares
/// no code with the solvers.
SteppedTurn time_stepping_turn(const scene::Scene& scene, const std::vector<double>& section, long steps);

}  // namespace rubsweep::audit
