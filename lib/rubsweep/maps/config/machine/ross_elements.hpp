#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// One element of a ROSS file: a map under a key such as "ShaftElement_Shaft Element 0", made of class and
/// tag.
struct RossElement {
  std::string type;  ///< part of the key before the first underscore, without 6DoF
  std::string tag;   ///< rest of the key; may have blanks and underscores
  std::string name;  ///< whole key
  yaml::Value value;
};

/// Part of a rotor kit with the number of its node. Nodes of the shaft count from 0, housings have larger
/// numbers.
template <class Part>
struct AtNode {
  Part part;
  int node = 0;
  const RossElement* element = nullptr;
};

/// Reads a shaft element as a segment without layers. Problems go to the element's diagnostics; if there is
/// any, the caller must not use the result.
AtNode<model::ShaftSegment> read_ross_shaft(const RossElement& element);
AtNode<model::Disc> read_ross_disc(const RossElement& element);

/// A point mass, of the shaft or of a housing.
struct RossMass {
  double x_kg = 0, y_kg = 0;
};
AtNode<RossMass> read_ross_mass(const RossElement& element);

/// Bearing or seal: its coefficients, constant or as a function of the speed, and the part on which it
/// stands.
struct RossSupport {
  model::Support support;
  std::optional<int> linked_node;
};
/// Reads a bearing or seal. `whirl_tables`: tables over `frequency` are over the whirl frequency, not the
/// speed.
AtNode<RossSupport> read_ross_support(const RossElement& element, bool whirl_tables);

/// Settings of a ROSS file that hold for the whole rotor.
struct RossSettings {
  double mass_damping_per_s = 0;   ///< alpha: damping of all masses, in the fixed frame
  double stiffness_damping_s = 0;  ///< beta: damping of the shaft by its stiffness
  /// true: tables over `frequency` use the whirl frequency, as since version 3; false: the speed of the
  /// shaft, as in earlier versions.
  bool whirl_tables = false;
};

/// Reads `ross_version` and `parameters` of a file, both optional. Problems: versions above 3, unknown
/// parameters, damping ratios of modes.
RossSettings read_ross_settings(const yaml::Value& file);

/// Elements of a ROSS file, sorted by kind, without thrust bearings, which act along the axis alone.
struct RossSections {
  std::vector<RossElement> shaft, discs, masses, supports;
};

/// Sorts the elements of a file. An element of unknown class is reported with its name.
RossSections read_ross_sections(const yaml::Value& root);

}  // namespace rubsweep::config::machine
