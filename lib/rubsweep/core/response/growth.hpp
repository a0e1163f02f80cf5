#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::response {

/// Relative error a step of a disturbance of which only the growth counts: no exponent is known as well.
inline constexpr double growth_accuracy = 1e-6;

/// One turn of a motion and of a small disturbance of it: moves the section and returns ln of the factor that
/// the disturbance grew by. Empty: the turn could not be made.
using Growth = std::function<std::optional<double>(std::span<double> section)>;

/// Length of a disturbance that is followed as the difference of two runs, in the units of the state
/// (sections: of the clearance). Between 1e-9 and 1e-4 it moves no exponent of the one-side map visibly
/// (tolerance 1e-8). Far below the tolerance the solver's noise parts the states, not the motion: at
/// tolerance 1e-5 separation 1e-6 shows exponents of +2 where there is rest, separation 1e-5 does not.
inline constexpr double separation = 1e-5;

/// A disturbance of that length with a share of every coordinate: one along a coordinate axis would never
/// leave an invariant subspace, such as the tangential motion at a flat wall.
Eigen::VectorXd first_disturbance(std::size_t states);

/// The disturbance is a tangent vector, moved by the exact derivative of the section where the turn has
/// closed forms: nothing is lost to the distance of two runs, and there is no second run. Turns without
/// closed forms take the difference to a second run that starts at `separation`. G. Benettin, L. Galgani,
/// J.-M. Strelcyn, Phys. Rev. A 14 (1976) 2338: the mean of what is returned tends to the largest exponent.
/// `map` must outlive what is returned.
Growth tangent_growth(proof::SceneMap& map);

/// ln of the factor that a disturbance of unit length has grown by to `direction`, which is given unit length
/// again. One that is shrunk to nothing starts anew.
double take_growth(Eigen::MatrixXd& direction);

}  // namespace rubsweep::response
