#include "rubsweep/maps/config/machine/ross_sections.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "rubsweep/maps/config/machine/ross_settings.hpp"
#include "rubsweep/maps/config/yaml/repeated_keys.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr std::array<std::string_view, 19> known_classes{"ShaftElement",
                                                         "DiskElement",
                                                         "PointMass",
                                                         "BearingElement",
                                                         "SealElement",
                                                         "BallBearingElement",
                                                         "RollerBearingElement",
                                                         "MagneticBearingElement",
                                                         "BearingFluidFlow",
                                                         "CylindricalBearing",
                                                         "THDCylindrical",
                                                         "PlainJournal",
                                                         "TiltingPad",
                                                         "FluidFilmBearing",
                                                         "SqueezeFilmDamper",
                                                         "LabyrinthSeal",
                                                         "HolePatternSeal",
                                                         "HybridSeal",
                                                         "ThrustPad"};
constexpr std::string_view with_axial_motion = "6DoF";  ///< end of the name of a class that has this, too

RossElement element_of(const yaml::Value& value, const std::string& name) {
  const std::size_t underscore = name.find('_');
  std::string type = name.substr(0, underscore);
  if (type.ends_with(with_axial_motion)) type.resize(type.size() - with_axial_motion.size());
  return {std::move(type), underscore == std::string::npos ? "" : name.substr(underscore + 1), name, value};
}

bool has_key(const yaml::Node& node, std::string_view name) {
  return std::ranges::any_of(node.keys, [&](const yaml::Node::Key& key) { return key.text == name; });
}

/// Whether an element acts along the axis alone, where nothing couples with bending.
bool is_thrust_bearing(const RossElement& element) {
  return has_key(element.value.node, "kzz") && !has_key(element.value.node, "kxx");
}

}  // namespace

RossSections read_ross_sections(const yaml::Value& root) {
  RossSections elements;
  refuse_repeated_keys(root.node, root.path, root.diagnostics);
  for (std::size_t i = 0; i < root.node.items.size(); ++i) {
    const std::string& name = root.node.keys[i].text;
    if (is_ross_setting(name)) continue;
    const yaml::Value value{root.node.items[i], yaml::child_path(root.path, name), root.diagnostics};
    RossElement element = element_of(value, name);
    if (value.node.kind != yaml::Node::Kind::map) {
      refuse(value, yaml::describe(value.node) + " and no element", yaml::describe(known_classes));
    } else if (std::ranges::count(known_classes, element.type) == 0) {
      refuse(
          value,
          "is of a class that cannot be represented, " + yaml::describe_unknown(element.type, known_classes),
          yaml::describe(known_classes));
    } else if (element.type == "ShaftElement") {
      elements.shaft.push_back(std::move(element));
    } else if (element.type == "DiskElement") {
      elements.discs.push_back(std::move(element));
    } else if (element.type == "PointMass") {
      elements.masses.push_back(std::move(element));
    } else if (!is_thrust_bearing(element)) {
      elements.supports.push_back(std::move(element));
    }
  }
  return elements;
}

}  // namespace rubsweep::config::machine
