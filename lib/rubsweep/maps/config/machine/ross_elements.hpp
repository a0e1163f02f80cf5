#pragma once

#include <string>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// One element of a ROSS file: the map under "ShaftElement_Shaft Element 0", by its class and its tag.
struct RossElement {
  std::string type;  ///< word before the first underscore, without 6DoF
  std::string tag;   ///< text after it: may have blanks and underscores
  std::string name;  ///< all of it
  yaml::Value value;
};

/// Parts of a rotor kit with the node that each stands on: those of the shaft count from 0, housings have
/// numbers beyond them.
template <class Part>
struct AtNode {
  Part part;
  int node = 0;
  const RossElement* element = nullptr;
};

/// A shaft element as a segment without layers. Problems go to the element's diagnostics; a part with a
/// problem is not used.
AtNode<model::ShaftSegment> read_ross_shaft(const RossElement& element);
AtNode<model::Disc> read_ross_disc(const RossElement& element);

/// A point mass, of the shaft or of a housing.
struct RossMass {
  double x_kg = 0, y_kg = 0;
};
AtNode<RossMass> read_ross_mass(const RossElement& element);

/// A bearing or seal: its coefficients, constant or over the speed, and what it stands on.
struct RossSupport {
  model::Support support;
  std::optional<int> linked_node;
};
/// `whirl_tables`: coefficients over `frequency` are those of a whirl frequency, not of a speed of the shaft.
AtNode<RossSupport> read_ross_support(const RossElement& element, bool whirl_tables);

}  // namespace rubsweep::config::machine
