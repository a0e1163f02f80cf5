#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/keys/machine_form.hpp"

namespace rubsweep::config::keys {

namespace {

Form text_or_file(std::size_t most_bytes) {
  return any_of(
      {text(most_bytes),
       map_of({must("file", text(), "file, its name relative to this one: Matrix Market, or .mat of MATLAB"),
               may("variable", text(), "name of the matrix in a file of MATLAB", "(the key)")})});
}

constexpr std::size_t most_rows = model::ShaftMatrices::most_degrees_of_freedom;

Form column(Form item) { return list_of(std::move(item), 1, most_rows); }

Form or_none(const model::Range& range) { return any_of({number(range), word({"none"})}); }

Form file_alone(const char* meaning) { return map_of({must("file", text(), meaning)}); }

Key degrees_of_freedom() {
  const model::Range places{.low = 0, .high = model::physical::length_m.high};
  return must(
      "degrees_of_freedom",
      any_of({file_alone("table with the columns node, direction, position_m and weight_kg"),
              map_of({must("node", column(text()), "name of the node"),
                      must("direction", column(word({"x", "y", "rx", "ry"})), "along or about an axis"),
                      must("position_m", column(or_none(places)),
                           "place along the shaft; none: of a body beside it"),
                      may("weight_kg", column(or_none(model::any_finite)), "mass that gravity pulls",
                          "(of the mass matrix)")})}),
      "degrees of freedom in the order of the rows");
}

Key matrix_unbalance() {
  std::vector<Key> of_node{must("node", text(), "name of the node"),
                           must("position_m", number(model::not_negative), "place along the shaft"),
                           must("mass_kg", number(model::physical::mass_kg), "mass that stands off"),
                           may("eccentricity_ratio", number(model::physical::per_eccentricity),
                               "distance from the axis, per metre of the cell's eccentricity", "1"),
                           may("phase_deg", number(model::any_finite), "angle of that distance", "0")};
  return must(
      "unbalance",
      any_of(
          {file_alone("table with the columns node, direction, real_kg and imaginary_kg"),
           map_of({must("node", column(text()), "name of the node"),
                   must("direction", column(word({"x", "y", "rx", "ry"})), "along or about an axis"),
                   must("real_kg", column(number(model::any_finite)), "per metre of eccentricity"),
                   must("imaginary_kg", column(number(model::any_finite)), "the same, a quarter turn on")}),
           list_of(map_of(std::move(of_node), {{.ways = {{.required = {"node"}, .optional = {}},
                                                         {.required = {"position_m"}, .optional = {}}}}}),
                   1, most_rows)}),
      "unbalance by nodes, or of each degree of freedom");
}

}  // namespace

std::vector<Key> matrix_keys() {
  constexpr std::size_t most_bytes = 16'000'000;
  std::vector<Key> keys =
      newer({must("mass", text_or_file(most_bytes), "mass matrix"),
             must("stiffness", text_or_file(most_bytes), "stiffness matrix"),
             may("damping", text_or_file(most_bytes), "damping matrix", "0"),
             may("gyroscopic", text_or_file(most_bytes), "gyroscopic matrix per rad/s", "0"),
             degrees_of_freedom(), matrix_unbalance()});
  constexpr std::array<std::string_view, 8> others{
      "supports",        "static_loads", "sensors",       "damping_ratio", "rotating_damping_ratio",
      "clearances_from", "modes",        "modes_up_to_hz"};
  for (Key& key : rotor_kit_keys()) {
    if (std::ranges::count(others, key.name) == 0) continue;
    if (key.name == "supports") key.required = false, key.fallback = "(none)";
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace rubsweep::config::keys
