#include "rubsweep/maps/config/machine/matrix_rotor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::machine {
namespace {

constexpr double same_place = 1e-9;  ///< largest distance of equal places, as a share of the shaft's length

/// Parts of a rotor kit that cannot be combined with matrices, and the reasons.
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

using namespace keys;

constexpr std::size_t most_rows = model::ShaftMatrices::most_degrees_of_freedom;

Form text_or_file() {
  constexpr std::size_t most_bytes = 16'000'000;
  return any_of(
      {text(most_bytes),
       map_of({must("file", text(), "file, its name relative to this one: Matrix Market, or .mat of MATLAB"),
               may("variable", text(), "name of the matrix in a file of MATLAB", "(the key)")})});
}

Form column(Form item) { return list_of(std::move(item), 1, most_rows); }

Form or_none(const model::Range& range) { return column(any_of({number(range), one_of({&no_place, 1})})); }

Form file_alone(const char* meaning) { return map_of({must("file", text(), meaning)}); }

Key node() { return must("node", column(text()), "name of the node"); }
Key direction() { return must("direction", column(one_of(directions)), "along or about an axis"); }

Form degrees_of_freedom() {
  const model::Range places{.low = 0, .high = model::physical::length_m.high};
  return any_of(
      {file_alone("table with the columns node, direction, position_m and weight_kg"),
       map_of({node(), direction(),
               must("position_m", or_none(places), "place along the shaft; none: of a body beside it"),
               may("weight_kg", or_none(model::any_finite), "mass that gravity pulls",
                   "(of the mass matrix)")})});
}

Form matrix_unbalance() {
  return any_of(
      {file_alone("table with the columns node, direction, real_kg and imaginary_kg"),
       map_of({node(), direction(),
               must("real_kg", column(number(model::any_finite)), "per metre of eccentricity"),
               must("imaginary_kg", column(number(model::any_finite)), "the same, a quarter turn on")}),
       list_of(map_of(joined({{must("node", text(), "name of the node"),
                               must("position_m", number(model::not_negative), "place along the shaft")},
                              keys_of<model::NodeUnbalance>()}),
                      {either(node_or_place)}),
               1, most_rows)});
}

/// Whether a key of a rotor kit cannot be combined with matrices, which contain its effect or exclude it.
bool is_excluded_by_matrices(std::string_view name) {
  return name == mass_damping_key ||
         std::ranges::any_of(excluded, [&](const auto& one) { return one.first == name; });
}

}  // namespace

void refuse_between_nodes(const yaml::Value& value, const model::RotorKit& kit) {
  if (!kit.matrices) return;
  if (value.node.kind == yaml::Node::Kind::list) {
    for (std::size_t i = 0; i < value.node.items.size(); ++i) refuse_between_nodes(value.at(i), kit);
    return;
  }
  const yaml::Node* place = yaml::entry(value.node, "position_m");
  if (place == nullptr) return;
  const auto wanted = yaml::number_of(*place);
  if (!wanted) return;  // refused where it was read
  double nearest = INFINITY;
  for (const model::DegreeOfFreedom& one : kit.matrices->degrees_of_freedom) {
    if (one.position_m && std::abs(*one.position_m - *wanted) < std::abs(nearest - *wanted))
      nearest = *one.position_m;
  }
  if (std::abs(nearest - *wanted) <= same_place * model::shaft_length_m(kit)) return;
  yaml::refuse({*place, value.path + ".position_m", value.diagnostics},
               fmt::format("at {} m stands no node", place->text),
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

std::vector<Key> matrix_rotor_keys() {
  std::vector<Key> keys;
  for (const MatrixKey& one : matrix_keys) {
    const std::string name(one.name), meaning(one.meaning);
    keys.push_back(newer_key(one.needed ? must(name, text_or_file(), meaning)
                                        : may(name, text_or_file(), meaning, "0")));
  }
  keys.push_back(newer_key(
      must(std::string(freedoms_key), degrees_of_freedom(), "degrees of freedom in the order of the rows")));
  keys.push_back(newer_key(must(std::string(unbalance_key), matrix_unbalance(),
                                "unbalance by nodes, or of each degree of freedom")));
  for (Key& key : rotor_kit_keys()) {
    if (is_excluded_by_matrices(key.name)) continue;
    if (key.name == "supports") key.required = false, key.fallback = "(none)";
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace rubsweep::config::machine
