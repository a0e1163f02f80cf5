#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/maps/config/machine/ross_elements.hpp"
#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr int latest_version = 3, first_with_whirl_tables = 3;

/// First number of a version such as "3.0.0"; empty where there is none.
std::optional<int> main_version(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = end == text.data() + text.size() || *end == '.';
  return error == std::errc() && whole && number >= 0 ? std::optional(number) : std::nullopt;
}

int read_version(const yaml::Value& value) {
  const auto version =
      value.node.kind == yaml::Node::Kind::scalar ? main_version(value.node.text) : std::nullopt;
  if (version && *version <= latest_version) return *version;
  refuse(value, fmt::format("'{}' is no version whose files are known", yaml::shown(value.node.text)),
         fmt::format("\"0\" to \"{}\" and what follows after a point", latest_version));
  return 0;
}

void read_damping(yaml::Section& parameters, RossSettings& settings) {
  const auto number = [&](std::string_view name, double& target, const model::Range& range) {
    const auto value = parameters.find(name);
    if (value && value->node.kind != yaml::Node::Kind::null) parameters.field(name, target, range);
  };
  number("alpha", settings.mass_damping_per_s, model::physical::rate_per_s);
  number("beta", settings.stiffness_damping_s, model::physical::duration_s);
  const auto ratios = parameters.find("modal_damping_ratio");
  if (!ratios || ratios->node.kind == yaml::Node::Kind::null) return;
  if (ratios->node.kind == yaml::Node::Kind::list && ratios->node.items.empty()) return;
  refuse(
      *ratios,
      "counts modes of torsion and along the axis among those of bending, and no bearing holds these modes",
      "none, and damping_ratio beside the name of the file");
}

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
constexpr std::string_view with_axial_motion = "6DoF";  ///< end of a class name with axial motion

RossElement element_of(const yaml::Value& value, const std::string& name) {
  const std::size_t underscore = name.find('_');
  std::string type = name.substr(0, underscore);
  if (type.ends_with(with_axial_motion)) type.resize(type.size() - with_axial_motion.size());
  return {std::move(type), underscore == std::string::npos ? "" : name.substr(underscore + 1), name, value};
}

/// Whether an element acts only along the axis. Motion along the axis does not couple with bending.
bool is_thrust_bearing(const RossElement& element) {
  return yaml::entry(element.value.node, "kzz") != nullptr &&
         yaml::entry(element.value.node, "kxx") == nullptr;
}

/// Whether a key of a file is a setting, not an element.
bool is_ross_setting(std::string_view key) {
  return key == "parameters" || key == "ross_version" || key == "_note";
}

}  // namespace

RossSettings read_ross_settings(const yaml::Value& file) {
  RossSettings settings;
  for (std::size_t i = 0; i < file.node.items.size(); ++i) {
    const std::string& name = file.node.keys[i].text;
    const yaml::Value value = file.at(i);
    if (name == "ross_version") settings.whirl_tables = read_version(value) >= first_with_whirl_tables;
    if (name != "parameters") continue;
    yaml::Section parameters(value);
    // Ignored are speeds that are used only for plots, and the default damping ratio of modes, because
    // damping ratios of modes are refused anyway.
    for (const std::string_view ignored : {"min_w", "max_w", "rated_w", "tag", "default_damping_ratio"})
      parameters.find(ignored);
    read_damping(parameters, settings);
  }
  return settings;
}

RossSections read_ross_sections(const yaml::Value& root) {
  RossSections elements;
  refuse_repeated_keys(root.node, root.path, root.diagnostics);
  for (std::size_t i = 0; i < root.node.items.size(); ++i) {
    const std::string& name = root.node.keys[i].text;
    if (is_ross_setting(name)) continue;
    const yaml::Value value = root.at(i);
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
