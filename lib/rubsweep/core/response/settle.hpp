#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/response/motion/classify.hpp"
#include "rubsweep/core/response/motion/motion.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/core/response/survival.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::response {

/// Result of a run from the kick to its verdict.
struct SettledRun {
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  motion::Motion motion;               ///< class `failed` when the outcome is not ok
  std::optional<motion::Proof> proof;  ///< empty: unsettled or failed
  /// Revolutions from the kick to the end of the windows, without those that only measure an exponent.
  std::optional<double> floquet_modulus;
  /// Revolutions from the kick to the end of the windows, without those for measuring an exponent.
  long revolutions = 0;
  std::optional<long> last_contact_revolution;  ///< counted from 1; empty: the wall was never touched
  std::optional<Survival> survival;             ///< observed survival of chaos
  bool slip_reversed = false;                   ///< true: a slip reversed in some turn
  /// Whether a free vibration of the rotor without its stops grows at this speed. There is then no quiet
  /// motion to return to, and only the stops limit the motion.
  bool rotor_unstable = false;
  integrate::run::Effort effort;
  /// State after these revolutions, scaled as TurnReport::section; empty where there is none.
  std::vector<double> section;
};

/// Runs `cell` turn by turn until its motion is known. The run ends as soon as rest or a stable orbit is
/// proven (of up to twice max_order turns; in a rotationally symmetric scene a circle or an oval) or
/// `TorusWatch` finds a torus. Otherwise the last two windows of `max_revolutions` decide. If these show
/// neither a period nor rest, a rotationally symmetric scene is searched for a comb. A motion that is still
/// undecided is followed by `classify_aperiodic`, at the run's tolerance or 1e-7, whichever is tighter.
SettledRun settle(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                  const motion::ResponseOptions& options, motion::Workspace& workspace);

/// Measures of the quiet motion of a cell without contact, in closed form.
motion::Measures quiet_measures(const scene::Cell& cell, const motion::ResponseOptions& options,
                                motion::Workspace& workspace);

}  // namespace rubsweep::response
