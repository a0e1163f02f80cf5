#pragma once

#include <Eigen/Core>

#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {

/// Load of couplings whose two ends are out of line, n, in the x plane: its parts force Re(load e^{i w t}).
Eigen::VectorXcd misalignment_load(const BeamShaft& shaft, const model::RotorKit& kit);

/// Constant load of couplings between machines that stand out of line, n: load in x + i load in y.
Eigen::VectorXcd standing_misalignment_load(const BeamShaft& shaft, const model::RotorKit& kit);

/// Where a constant load, in x + i in y, holds the shaft that does not turn: q_x + i q_y, n. Supports that
/// follow the speed count with their coefficients at the middle one.
Eigen::VectorXcd position_at_rest(const BeamShaft& shaft, const Eigen::VectorXcd& load);

/// Load of couplings that are not equally stiff all around, to first order in their asymmetry, n, in the x
/// plane: its parts force Re(load e^{2 i w t}), y lags by a quarter of that. `at_rest`: as of
/// position_at_rest, under all constant loads.
///
/// With D = q behind the coupling - q before it + misalignment, all x + i y, and the stiff axis at w t + a,
/// the coupling pushes its end behind by -k D - k ratio e^{2 i (w t + a)} conj(D): the restoring force of k
/// (1 + ratio) along the axis and k (1 - ratio) across it. The second term with D at rest is the load; the
/// rest of D, the vibration, is left out of it.
Eigen::VectorXcd twice_per_turn_load(const BeamShaft& shaft, const model::RotorKit& kit,
                                     const Eigen::VectorXcd& at_rest);

}  // namespace rubsweep::structure
