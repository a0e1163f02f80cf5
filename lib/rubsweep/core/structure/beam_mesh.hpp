#pragma once

#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::structure {

constexpr double same_place = 1e-9;  ///< of the shaft's length: stations nearer to each other are one

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

}  // namespace rubsweep::structure
