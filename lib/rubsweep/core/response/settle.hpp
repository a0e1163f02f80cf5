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

/// A run from the kick to its verdict.
struct SettledRun {
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;
  motion::Motion motion;                  ///< class `failed` when the outcome is not ok
  std::optional<motion::Proof> proof;     ///< empty: unsettled or failed
  std::optional<double> floquet_modulus;  ///< largest multiplier of a proven orbit over its period
  /// From the kick to the end of the windows; those that measure an exponent do not count.
  long revolutions = 0;
  std::optional<long> last_contact_revolution;  ///< 1 for the first; empty: the wall was never touched
  std::optional<Survival> survival;             ///< survival of chaos: how long it was seen to last
  bool slip_reversed = false;                   ///< true: a slip reversed, as in the turns
  /// Some free vibration of the rotor without its stops grows at this speed: there is no quiet motion to
  /// which it could return, and nothing but the stops limits what it does.
  bool rotor_unstable = false;
  integrate::run::Effort effort;
  /// The state after these revolutions, scaled as TurnReport::section; empty where there was none.
  std::vector<double> section;
};

/// Runs `cell` turn by turn until its motion is known: at once when rest or a stable orbit (of up to twice
/// max_order turns; in a rotationally symmetric scene a circle or an oval) is proven, once `TorusWatch` sees
/// a torus, else after `max_revolutions`, whose last two windows decide. When both windows find neither a
/// period nor rest, a rotationally symmetric scene is searched for a comb; a motion still undecided is
/// followed further by `classify_aperiodic`, at the run's tolerance or 1e-7, whichever is tighter.
SettledRun settle(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                  const motion::ResponseOptions& options, motion::Workspace& workspace);

/// Measures of the quiet motion of a cell that touches nothing, from its closed form.
motion::Measures quiet_measures(const scene::Cell& cell, const motion::ResponseOptions& options,
                                motion::Workspace& workspace);

}  // namespace rubsweep::response
