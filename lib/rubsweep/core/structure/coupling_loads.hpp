#pragma once

#include <Eigen/Core>

#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {

/// Load by couplings with turning offset or tilt, n, in the x plane: force Re(load e^{i w t}).
Eigen::VectorXcd misalignment_load(const BeamShaft& shaft, const model::RotorKit& kit);

/// Constant load of couplings between misaligned machines, n: load in x + i load in y.
Eigen::VectorXcd standing_misalignment_load(const BeamShaft& shaft, const model::RotorKit& kit);

/// Static position q_x + i q_y, n, of the shaft at standstill under a constant load (x + i y). Supports with
/// tables have their coefficients at the middle speed.
Eigen::VectorXcd position_at_rest(const BeamShaft& shaft, const Eigen::VectorXcd& load);

/// Load by couplings whose stiffness depends on direction, to first order in their asymmetry, n, in the x
/// plane: force Re(load e^{2 i w t}), y lags by a quarter of that period. `at_rest`: position_at_rest under
/// all constant loads.
///
/// With D = q behind the coupling - q before it + misalignment, all x + i y, and the stiff axis at w t + a,
/// the coupling acts on its rear end with -k D - k ratio e^{2 i (w t + a)} conj(D). This is the restoring
/// force of k (1 + ratio) along the axis and k (1 - ratio) across it. The load is the second term with D at
/// rest; the vibration part of D is neglected there.
Eigen::VectorXcd twice_per_turn_load(const BeamShaft& shaft, const model::RotorKit& kit,
                                     const Eigen::VectorXcd& at_rest);

}  // namespace rubsweep::structure
