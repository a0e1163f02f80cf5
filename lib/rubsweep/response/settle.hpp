#pragma once

#include <optional>

#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/response/classify.hpp"
#include "rubsweep/response/options.hpp"
#include "rubsweep/response/proof.hpp"
#include "rubsweep/response/workspace.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::response {

/// A run from the kick to its verdict.
struct SettledRun {
  integrate::Outcome outcome = integrate::Outcome::ok;
  Motion motion;                          ///< class `failed` when the outcome is not ok
  std::optional<Proof> proof;             ///< empty: unsettled or failed
  std::optional<double> floquet_modulus;  ///< of a proven orbit: largest multiplier over its period
  /// From the kick to the end of the windows; those that measure an exponent do not count.
  long revolutions = 0;
  std::optional<long> last_contact_revolution;  ///< 1 for the first; empty: the wall was never touched
  bool slip_reversed = false;                   ///< some slip speed was <= 0 while touching
  integrate::Effort effort;
};

/// Runs `cell` turn by turn until its motion is known: at once when rest or a stable orbit (of up to twice
/// max_order turns; in a rotationally symmetric scene a circle or an oval) is proven, else after
/// `max_revolutions`, whose last two windows decide. When both windows find neither a period nor rest, a
/// rotationally symmetric scene is searched for a comb, and what is left undecided is followed further by
/// `classify_aperiodic`, at the run's tolerance or 1e-7, whichever is tighter.
SettledRun settle(const scene::Cell& cell, const integrate::SolverOptions& solver,
                  const ResponseOptions& options, Workspace& workspace);

/// Measures of the quiet motion of a cell that touches nothing, from its closed form.
Measures quiet_measures(const scene::Cell& cell, const ResponseOptions& options, Workspace& workspace);

}  // namespace rubsweep::response
