#include <array>
#include <string_view>
#include <utility>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/matrix_keys.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"

namespace rubsweep::config::machine {
namespace {

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

}  // namespace

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
