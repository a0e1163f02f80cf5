#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/response/classify.hpp"
#include "rubsweep/response/options.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::response {

/// What the class of a motion rests on.
enum class Proof {
  rest,      ///< a bound on the free vibration: no contact can ever come again
  observed,  ///< two successive windows at the end of the run agree
};

constexpr std::string_view to_string(Proof proof) { return proof == Proof::rest ? "rest" : "observed"; }

/// A run from the kick to its verdict.
struct SettledRun {
  integrate::Outcome outcome = integrate::Outcome::ok;
  Motion motion;               ///< class `failed` when the outcome is not ok
  std::optional<Proof> proof;  ///< empty: unsettled or failed
  long revolutions = 0;        ///< revolutions integrated
  std::optional<long> last_contact_revolution;  ///< 1 for the first; empty: the wall was never touched
  bool slip_reversed = false;                   ///< some slip speed was <= 0 while touching
  integrate::Effort effort;
};

/// Asks `cursor` (a run of `cell`, at its start) for turn after turn until the motion is known: at once when rest is
/// proven, else after `max_revolutions`, whose last two windows decide.
SettledRun settle(const integrate::Cursor& cursor, const scene::Cell& cell, const ResponseOptions& options,
                  SpectrumWorkspace& workspace);

/// Measures of the quiet motion of a cell that touches nothing, from its closed form.
Measures quiet_measures(const scene::Cell& cell, const ResponseOptions& options, SpectrumWorkspace& workspace);

}  // namespace rubsweep::response
