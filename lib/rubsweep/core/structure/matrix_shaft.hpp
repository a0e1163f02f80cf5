#pragma once

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {

/// The matrices as a beam shaft: nodes on the shaft by their position, each with deflection and slope, then
/// one coordinate for each pair of directions of the bodies beside it. All stiffness is that of supports and
/// all mass is added mass, plane by plane, so that no bit is lost; a slope that the matrices leave out has a
/// stiffness that nothing bends. Throws ConfigError with the first of problems_of.
BeamShaft matrix_shaft(const model::ShaftMatrices& matrices);

}  // namespace rubsweep::structure
