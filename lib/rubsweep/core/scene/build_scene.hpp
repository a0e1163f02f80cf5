#pragma once

#include <variant>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// The unbalance of a cell is given by a whirl ratio or by an eccentricity.
struct WhirlRatio {
  double value = 0;  ///< largest normal excursion of the quiet motion / clearance left at the first stop
};
struct Eccentricity {
  double value_m = 0;
};
using Unbalance = std::variant<WhirlRatio, Eccentricity>;

/// Position of a cell in a map.
struct Place {
  double speed_hz = 0;
  Unbalance unbalance;
};

enum class Start {
  quiet,    ///< whirls without contact until the kick
  contact,  ///< the quiet motion itself reaches a wall: starts at rest with the unbalance, without a kick
  initial_contact,  ///< static forces leave no clearance at the first stop, so that no unbalance gives the
                    ///< whirl ratio
  unreachable,      ///< no finite eccentricity gives the whirl ratio (undamped resonance), or there is no
                    ///< quiet motion
};

/// Whether a cell with this start can be simulated.
constexpr bool can_run(Start start) { return start == Start::quiet || start == Start::contact; }

/// One cell of a map, ready to run when can_run(start).
struct Cell {
  Scene scene;
  QuietMotion quiet;
  /// One of the two is given, the other is computed. NaN where it does not exist: at an undamped resonance,
  /// or where static forces leave no clearance at the first stop.
  double eccentricity_m = 0, whirl_ratio = 0;
  Start start = Start::quiet;
};

/// Scene of a prepared machine at one speed and unbalance. It starts on the closed-form quiet whirl, with t =
/// 0 at the instant of smallest gap at the first stop, or later by the kick's phase. The kick points at that
/// stop's wall unless it has an angle. Where the quiet motion itself reaches a wall, the rotor starts at
/// rest, like a machine that is switched on: in its static position or as far towards it as the walls allow,
/// with the same phase of the unbalance, without the kick. A bow and forces at twice the speed do not scale
/// with the unbalance; where two eccentricities give the whirl ratio, the larger one is used. If the machine
/// gives a start state, it replaces this start (start_in_given_state). speed_hz > 0, and within the tables of
/// all supports (structure::refuse_beyond_tables). A machine with tables has the same coordinates at all
/// speeds; prepared_at gives a machine with the coordinates of a single speed.
Cell build_cell(const PreparedMachine& prepared, double speed_hz, const Unbalance& unbalance);

/// Builds a single cell and prepares its machine at this speed. Throws ConfigError for an invalid `machine`.
Cell build_cell(const model::Machine& machine, double speed_hz, const Unbalance& unbalance);

}  // namespace rubsweep::scene
