#pragma once

#include <Eigen/Core>

#include "rubsweep/model/rotor_kit.hpp"

namespace rubsweep::structure {

/// Timoshenko beam element of a round shaft in one plane. Coordinates (w1, s1, w2, s2): deflection in metres
/// and angle of the cross-section in radians at both ends, s = dw/dz without shear. In the complex notation
/// w = x + iy: mass w'' - i speed gyroscopic w' + stiffness w = forces, the same real matrices in both
/// planes.
struct BeamElement {
  Eigen::Matrix4d mass;        ///< translation and rotary inertia, consistent
  Eigen::Matrix4d gyroscopic;  ///< twice the rotary inertia, the polar moment of a round section
  Eigen::Matrix4d stiffness;
};

/// Element of `segment`'s section and material, `length_m` long. Exact for static end loads;
/// frequencies converge with the fourth order of the element's length, their share from shear with the second
/// (Przemieniecki, Theory of Matrix Structural Analysis, 1968, sections 5.6 and 11.4; Friswell, Penny,
/// Garvey, Lees, Dynamics of Rotating Machines, 2010, section 5.4).
BeamElement timoshenko_element(const model::ShaftSegment& segment, double length_m);

/// Shear coefficient of a round hollow section (Cowper, J. Appl. Mech. 33, 1966): the mean shear strain is
/// Q / (coefficient G A).
double shear_coefficient(const model::ShaftSegment& segment);

/// Cross-section: area in m^2, second moment of area about a diameter in m^4.
double section_area_m2(const model::ShaftSegment& segment);
double section_moment_m4(const model::ShaftSegment& segment);

}  // namespace rubsweep::structure
