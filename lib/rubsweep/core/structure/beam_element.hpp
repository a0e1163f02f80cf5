#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::structure {

constexpr double same_place = 1e-9;  ///< share of the shaft's length: stations nearer to each other are one

/// Piece of a segment between two nodes.
struct MeshElement {
  std::size_t first_node;
  double length_m;
  const model::ShaftSegment* segment;
  double from, to;  ///< shares of the segment's length
};

struct BeamMesh {
  std::vector<double> node_position_m;  ///< ascending; twice the same at a coupling
  std::vector<MeshElement> elements;
};

/// Adds the places on the shaft where something of a kit stands that is not part of the shaft itself.
void add_places(const model::RotorKit& kit, std::vector<double>& stations_m);

/// Nodes at the ends of segments, at every part and at `stations_m`, and elements between them no longer than
/// the shaft's length / kit.elements. The kit must outlive the mesh.
BeamMesh mesh_of(const model::RotorKit& kit, std::vector<double> stations_m);

/// Timoshenko beam element of a round shaft in one plane. Coordinates (w1, s1, w2, s2): deflection in metres
/// and angle of the cross-section in radians at both ends, s = dw/dz without shear. In the complex notation
/// w = x + iy: mass w'' - i speed gyroscopic w' + stiffness w = forces, the same real matrices in both
/// planes.
struct BeamElement {
  Eigen::Matrix4d mass;        ///< translation and rotary inertia, consistent
  Eigen::Matrix4d gyroscopic;  ///< twice the rotary inertia, the polar moment of a round section
  Eigen::Matrix4d stiffness;
  Eigen::Matrix4d damping;  ///< mass_damping_per_s mass + stiffness_damping_s stiffness of each layer
  double polar_inertia_kg_m2 = 0;
};

/// Element of `layer`'s section and material, `length_m` long: the part of its segment between these shares
/// of the segment's length. Exact for static end loads where it is straight; frequencies converge with the
/// fourth order of the element's length, their share from shear with the second (Przemieniecki, Theory of
/// Matrix Structural Analysis, 1968, sections 5.6 and 11.4; Friswell, Penny, Garvey, Lees, Dynamics of
/// Rotating Machines, 2010, section 5.4). A taper has the deflections of a straight element with the section
/// at half length, its energies are those of the true section.
BeamElement timoshenko_element(const model::ShaftLayer& layer, double length_m, double from = 0,
                               double to = 1);

/// The sum of a segment's own element and those of its layers, whose ends move together.
BeamElement layered_element(const model::ShaftSegment& segment, double length_m, double from, double to);

/// Shear coefficient of a round hollow section, `at` this share of the segment's length: by Cowper, or
/// Hutchinson's, which is 6 (1 + nu)^2 / (7 + 12 nu + 4 nu^2) of a solid one. Infinite without shear.
double shear_coefficient(const model::ShaftLayer& layer, double at = 0);

/// Cross-section that has mass, `at` this share of the segment's length: area in m^2, second moment of area
/// about a diameter in m^4.
double section_area_m2(const model::ShaftLayer& layer, double at = 0);
double section_moment_m4(const model::ShaftLayer& layer, double at = 0);

}  // namespace rubsweep::structure
