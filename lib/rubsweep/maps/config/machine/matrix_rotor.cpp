#include "rubsweep/maps/config/machine/matrix_rotor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/machine/shaft_matrices.hpp"
#include "rubsweep/maps/config/yaml/number.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr double same_place = 1e-9;  ///< of the shaft's length

/// Parts of a rotor kit that matrices exclude, and why.
constexpr std::pair<std::string_view, std::string_view> excluded[]{
    {"shaft", "is what the matrices stand for"},
    {"discs", "are what the matrices stand for"},
    {"point_masses", "are what the matrices stand for"},
    {"housings", "are what the matrices stand for"},
    {"elements", "are those of the program that made the matrices"},
    {"couplings", "need the shaft's own stiffness, which matrices do not part from that of its supports"},
    {"bow", "needs the shaft's own stiffness, which matrices do not part from that of its supports"},
    {"torsion", "needs the polar inertia, which matrices of lateral motion do not hold"}};

constexpr std::string_view mass_damping_key = "mass_damping_per_s";

bool refuse_excluded(yaml::Section& section) {
  bool any = false;
  for (const auto& [name, why] : excluded) {
    const auto value = section.find(name);
    if (value) refuse(*value, std::string(why), "a rotor of kind: rotor_kit");
    any = any || value;
  }
  return any;
}

void refuse_loose_matrices(yaml::Section& section, const model::RotorKit& kit) {
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, {});
  for (const std::size_t plane : {0U, 1U}) {
    if (numerics::dense::CholeskyFactors(shaft.plane_stiffness(plane)).positive_definite()) continue;
    refuse(*section.find("stiffness"),
           fmt::format("is not positive definite: the rotor is free to move in {}", plane == 0 ? "x" : "y"),
           "the stiffness of a rotor that is held, or supports that hold it");
  }
}

bool has_bodies(const model::ShaftMatrices& matrices) {
  return std::ranges::any_of(matrices.degrees_of_freedom,
                             [](const model::DegreeOfFreedom& one) { return !one.position_m; });
}

}  // namespace

bool is_excluded_by_matrices(std::string_view name) {
  return name == mass_damping_key ||
         std::ranges::any_of(excluded, [&](const auto& one) { return one.first == name; });
}

void refuse_between_nodes(const yaml::Value& value, const model::RotorKit& kit) {
  if (!kit.matrices) return;
  if (value.node.kind == yaml::Node::Kind::list) {
    for (std::size_t i = 0; i < value.node.items.size(); ++i)
      refuse_between_nodes({value.node.items[i], fmt::format("{}.{}", value.path, i), value.diagnostics},
                           kit);
    return;
  }
  const auto key = std::ranges::find(value.node.keys, "position_m", &yaml::Node::Key::text);
  if (key == value.node.keys.end()) return;
  const yaml::Node& place = value.node.items[static_cast<std::size_t>(key - value.node.keys.begin())];
  const yaml::ParsedNumber wanted = yaml::parse_number(place.text);
  if (wanted.error != yaml::NumberError::none) return;  // refused where it was read
  double nearest = INFINITY;
  for (const model::DegreeOfFreedom& one : kit.matrices->degrees_of_freedom) {
    if (one.position_m && std::abs(*one.position_m - wanted.value) < std::abs(nearest - wanted.value))
      nearest = *one.position_m;
  }
  if (std::abs(nearest - wanted.value) <= same_place * model::shaft_length_m(kit)) return;
  yaml::refuse({place, value.path + ".position_m", value.diagnostics},
               fmt::format("at {} m stands no node", place.text),
               fmt::format("a position_m of degrees_of_freedom, of which {} is the nearest", nearest));
}

model::RotorKit read_matrix_rotor(yaml::Section& section) {
  model::RotorKit kit;
  kit.matrices = read_shaft_matrices(section);
  const bool any_excluded = refuse_excluded(section);
  const auto supports = section.find("supports");
  if (supports) read_supports(*supports, kit);
  if (!any_excluded) {
    read_kit_rest(section, kit);
    if (const auto value = section.find(mass_damping_key))
      refuse(*value, "is part of what the damping matrix says", "a rotor of kind: rotor_kit");
  }
  for (const std::string_view name : {"supports", "static_loads", "sensors"}) {
    if (const auto value = section.find(name)) refuse_between_nodes(*value, kit);
  }
  if (supports && section.is_sound()) refuse_tables(*supports, section, kit);
  if (const auto value = section.find("rotating_damping_ratio");
      value && kit.matrices && model::has_rotating_damping(kit) && has_bodies(*kit.matrices))
    refuse(*value, "turns with the shaft, and bodies beside it do not",
           "0 beside degrees of freedom without position_m");
  if (kit.matrices && section.is_sound()) refuse_loose_matrices(section, kit);
  return kit;
}

}  // namespace rubsweep::config::machine
