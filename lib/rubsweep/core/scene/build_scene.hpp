#pragma once

#include <variant>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// How much unbalance a cell has: either way of saying it.
struct WhirlRatio {
  double value = 0;  ///< largest normal excursion of the quiet motion / remaining clearance at the first stop
};
struct Eccentricity {
  double value_m = 0;
};
using Unbalance = std::variant<WhirlRatio, Eccentricity>;

/// Where in a map a cell lies.
struct Place {
  double speed_hz = 0;
  Unbalance unbalance;
};

enum class Start {
  quiet,    ///< whirls without touching; the kick decides
  contact,  ///< the quiet motion itself reaches a wall: starts at rest, unbalance on, and is not kicked
  initial_contact,  ///< static forces leave no clearance at the first stop, so that no unbalance gives the
                    ///< whirl ratio
  unreachable,      ///< no finite eccentricity gives the whirl ratio (undamped resonance), or no quiet motion
                    ///< exists
};

/// True when a cell that starts so has a motion to run.
constexpr bool can_run(Start start) { return start == Start::quiet || start == Start::contact; }

/// One cell of a map, ready to run when can_run(start).
struct Cell {
  Scene scene;
  QuietMotion quiet;
  /// One of the two was given, the other belongs to it. NaN where there is none: at an undamped resonance, or
  /// where static forces leave no clearance at the first stop.
  double eccentricity_m = 0, whirl_ratio = 0;
  Start start = Start::quiet;
};

/// Scene of a prepared machine at one speed and unbalance: starts on the closed-form quiet whirl with t = 0
/// at the instant of smallest gap at the first stop, or later by the kick's phase; the kick points at that
/// stop's wall unless it has an angle of its own. Where the quiet motion itself reaches a wall, the rotor
/// starts at rest in its static position instead, or as far on the way to it as the walls let it, with the
/// same phase of the unbalance and without the kick: that motion is what a machine does that is switched on.
/// A bow of the shaft, and forces of twice the speed, stay what they are whatever the unbalance; where two
/// eccentricities give the whirl ratio, the larger one is taken. A state that the machine gives
/// (start_in_given_state) has the last word. speed_hz > 0, and within the tables of all supports
/// (structure::refuse_beyond_tables). A machine with tables has the same coordinates at all speeds;
/// prepared_at gives one with those of a single speed.
Cell build_cell(const PreparedMachine& prepared, double speed_hz, const Unbalance& unbalance);

/// The same for a single cell, prepared at its speed. Throws ConfigError where `machine` is not valid.
Cell build_cell(const model::Machine& machine, double speed_hz, const Unbalance& unbalance);

}  // namespace rubsweep::scene
