#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::structure {

constexpr double same_place = 1e-9;  ///< share of the shaft's length: closer stations are merged

/// Piece of a segment between two nodes.
struct MeshElement {
  std::size_t first_node;
  double length_m;
  const model::ShaftSegment* segment;
  double from, to;  ///< shares of the segment's length
};

struct BeamMesh {
  std::vector<double> node_position_m;  ///< ascending; a coupling has two nodes at one position
  std::vector<MeshElement> elements;
};

/// Adds the positions of all parts of a kit on the shaft that are not segments of it.
void add_places(const model::RotorKit& kit, std::vector<double>& stations_m);

/// Nodes at the ends of segments, at every part and at `stations_m`, and elements between them no longer than
/// the shaft's length / kit.elements. The kit must outlive the mesh.
BeamMesh mesh_of(const model::RotorKit& kit, std::vector<double> stations_m);

/// Timoshenko beam element of a round shaft in one plane. Coordinates (w1, s1, w2, s2): deflection in metres
/// and angle of the cross-section in radians at both ends; s = dw/dz without shear. With w = x + iy in
/// complex notation: mass w'' - i speed gyroscopic w' + stiffness w = forces, with the same real matrices in
/// both planes.
struct BeamElement {
  Eigen::Matrix4d mass;        ///< translation and rotary inertia, consistent mass matrix
  Eigen::Matrix4d gyroscopic;  ///< twice the rotary inertia, as the polar moment of a round section
  Eigen::Matrix4d stiffness;
  Eigen::Matrix4d damping;  ///< per layer: mass_damping_per_s mass + stiffness_damping_s stiffness
  double polar_inertia_kg_m2 = 0;
};

/// Element with the section and material of `layer`, `length_m` long, between the shares `from` and `to` of
/// its segment's length. A straight element is exact for static end loads. Frequencies converge with the
/// fourth order of the element's length, their shear part with the second (Przemieniecki, Theory of Matrix
/// Structural Analysis, 1968, sections 5.6 and 11.4; Friswell, Penny, Garvey, Lees, Dynamics of Rotating
/// Machines, 2010, section 5.4). For a tapered element, the shape functions are those of a straight element
/// with the section at half length, but the energies are those of its true section.
BeamElement timoshenko_element(const model::ShaftLayer& layer, double length_m, double from = 0,
                               double to = 1);

/// Sum of the elements of a segment and of its layers, whose ends move together.
BeamElement layered_element(const model::ShaftSegment& segment, double length_m, double from, double to);

/// Shear coefficient of a round hollow section at the share `at` of the segment's length, by Cowper or by
/// Hutchinson. Hutchinson's value for a solid section is 6 (1 + nu)^2 / (7 + 12 nu + 4 nu^2). Infinite
/// without shear.
double shear_coefficient(const model::ShaftLayer& layer, double at = 0);

/// Cross-section for the mass at the share `at` of the segment's length: area in m^2, second moment of area
/// about a diameter in m^4.
double section_area_m2(const model::ShaftLayer& layer, double at = 0);
double section_moment_m4(const model::ShaftLayer& layer, double at = 0);

}  // namespace rubsweep::structure
