
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/model/physical_range.hpp"
#include "rubsweep/core/structure/matrix_problems.hpp"
#include "rubsweep/maps/config/machine/matrix_market.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/machine/table_file.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::machine {
namespace {

using model::ShaftMatrices;

constexpr std::size_t most = ShaftMatrices::most_degrees_of_freedom;
constexpr std::string_view matrix_form = "a map with file, or the text of a Matrix Market file";
constexpr std::string_view freedoms_form = "a map with file, or one with node, direction and position_m";
constexpr std::string_view unbalance_form =
    "a map with file, one with node, direction, real_kg and imaginary_kg, or a list of maps";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Key of a column of these tables: the name of the column, if it is a known one.
ColumnKey key_of_table(const table::Heading& heading) {
  constexpr std::array<std::string_view, 6> known{"node",      "direction", "position_m",
                                                  "weight_kg", "real_kg",   "imaginary_kg"};
  return {std::ranges::find(known, heading.name) == known.end() ? "" : heading.name};
}

/// Replaces a map that names a file by the text of that file.
void resolve_matrix(yaml::Node& matrix, std::string_view key, yaml::Diagnostics& diagnostics) {
  yaml::Node* file = child(&matrix, "file");
  if (file == nullptr) return;
  const yaml::Value map{matrix, fmt::format("rotor.{}", key), diagnostics};
  yaml::Section section(map);
  const yaml::Value name = *section.find("file");
  const auto variable = section.find("variable");
  section.refuse_unknown_keys();
  std::filesystem::path path;
  if (!section.is_sound()) return;
  const auto bytes = read_named_file(name, path);
  if (!bytes) return;
  if (path.extension() == ".mat") {
    const auto text = variable ? read_text(*variable) : std::optional(std::string(key));
    const auto read =
        text ? read_matlab_matrix(bytes->text, *text, variable ? *variable : name) : std::nullopt;
    if (read) matrix = {yaml::Node::Kind::scalar, name.node.place, matrix_market(*read), true};
    return;
  }
  if (variable) {
    refuse(*variable, "is given for a file that is not MATLAB's", "a file that ends in .mat");
    return;
  }
  const int index = diagnostics.add_file(yaml::shown(path.string(), yaml::max_text_bytes));
  matrix = {yaml::Node::Kind::scalar, {-1, 1, 1, index}, bytes->text};
}

/// Whether a value still names a file: the file could not be read, and that was reported.
bool is_still_a_file(const yaml::Value& value) { return yaml::entry(value.node, "file") != nullptr; }

/// Columns of a table, each as long as the first; empty after a problem.
std::vector<yaml::Value> items_of(yaml::Section& section, std::string_view name, std::size_t& rows) {
  const auto list = section.require(name, "a list");
  auto items = list ? read_list(*list, most) : std::vector<yaml::Value>{};
  if (rows == 0) rows = items.size();
  if (items.size() == rows || items.empty()) return items;
  refuse(*list, fmt::format("holds {} values", items.size()),
         fmt::format("{}, as many as the first column", rows));
  return {};
}

std::optional<model::Direction> read_direction(const yaml::Value& value) {
  const auto index = yaml::read_word(value, directions);
  return index ? std::optional(static_cast<model::Direction>(*index)) : std::nullopt;
}

/// Whether a cell holds no value: it is empty or holds the word `none`.
bool says_nothing(const yaml::Node& node) {
  return node.kind == yaml::Node::Kind::scalar &&
         (node.text == no_place || (node.text.empty() && !node.quoted));
}

std::optional<double> read_or_nothing(const yaml::Value& value, const model::Range& range) {
  return says_nothing(value.node) ? std::nullopt : read_number(value, range);
}

/// Degrees of freedom, and for each the value of the configuration at which its problems are reported.
struct Freedoms {
  std::vector<model::DegreeOfFreedom> all;
  std::vector<yaml::Value> rows;

  std::optional<std::size_t> find(const std::string& node, model::Direction direction) const {
    const auto found = std::ranges::find_if(all, [&](const model::DegreeOfFreedom& one) {
      return one.node == node && one.direction == direction;
    });
    return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
  }
};

std::optional<Freedoms> read_freedoms(const yaml::Value& value) {
  if (is_still_a_file(value)) return std::nullopt;
  yaml::Section section(value, freedoms_form);
  std::size_t rows = 0;
  const auto nodes = items_of(section, "node", rows), along = items_of(section, "direction", rows),
             places = items_of(section, "position_m", rows);
  const auto weights =
      section.find("weight_kg") ? items_of(section, "weight_kg", rows) : std::vector<yaml::Value>{};
  section.refuse_unknown_keys();
  if (!section.is_sound()) return std::nullopt;
  Freedoms freedoms;
  bool any_on_shaft = false;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto node = read_text(nodes[i]);
    const auto direction = read_direction(along[i]);
    const auto place = read_or_nothing(places[i], {.low = 0, .high = model::physical::length_m.high});
    const auto weight = weights.empty() ? std::nullopt : read_or_nothing(weights[i], model::any_finite);
    any_on_shaft = any_on_shaft || place;
    if (!node || !direction) continue;
    if (freedoms.find(*node, *direction))
      refuse(along[i],
             fmt::format("{} of node {} stands twice", directions[static_cast<std::size_t>(*direction)],
                         yaml::shown(*node)),
             "each direction of a node once");
    freedoms.all.push_back({*node, *direction, place, weight});
    freedoms.rows.push_back(along[i]);
  }
  if (section.is_sound() && !any_on_shaft)
    refuse(value, "has no node on the shaft", "a position_m for at least one");
  if (!section.is_sound()) return std::nullopt;
  return freedoms;
}

void read_unbalance_columns(const yaml::Value& value, const Freedoms& freedoms, ShaftMatrices& matrices) {
  yaml::Section section(value, unbalance_form);
  std::size_t rows = 0;
  const auto nodes = items_of(section, "node", rows), along = items_of(section, "direction", rows),
             real = items_of(section, "real_kg", rows), imaginary = items_of(section, "imaginary_kg", rows);
  section.refuse_unknown_keys();
  if (!section.is_sound()) return;
  for (std::size_t i = 0; i < rows; ++i) {
    const auto node = read_text(nodes[i]);
    const auto direction = read_direction(along[i]);
    const auto re = read_number(real[i], model::any_finite),
               im = read_number(imaginary[i], model::any_finite);
    if (!node || !direction || !re || !im) continue;
    const auto at = freedoms.find(*node, *direction);
    const auto index = static_cast<Eigen::Index>(at.value_or(0));
    if (!at) {
      refuse(nodes[i],
             fmt::format("{} of node {} is no degree of freedom",
                         directions[static_cast<std::size_t>(*direction)], yaml::shown(*node)),
             "those of degrees_of_freedom");
    } else if (!std::isnan(matrices.unbalance_kg(index).real())) {
      refuse(nodes[i],
             fmt::format("{} of node {} stands twice", directions[static_cast<std::size_t>(*direction)],
                         yaml::shown(*node)),
             "each degree of freedom once");
    } else {
      matrices.unbalance_kg(index) = {*re, *im};
    }
  }
}

std::optional<std::string> node_at(const Freedoms& freedoms, double position_m, double length_m) {
  constexpr double same_place = 1e-9;
  for (const model::DegreeOfFreedom& one : freedoms.all) {
    if (one.position_m && std::abs(*one.position_m - position_m) <= same_place * length_m) return one.node;
  }
  return std::nullopt;
}

void read_node_unbalance(const yaml::Value& item, const Freedoms& freedoms, ShaftMatrices& matrices) {
  yaml::Section section(item);
  model::NodeUnbalance unbalance;
  section.require_exactly_one(node_or_place);
  const auto node = section.find("node"), place = section.find("position_m");
  read_fields(section, unbalance);
  section.refuse_unknown_keys();
  if (!section.is_sound()) return;
  std::optional<std::string> found;
  if (node) {
    const auto name = read_text(*node);
    const auto is_named = [&](const model::DegreeOfFreedom& one) {
      return one.position_m && one.node == *name;
    };
    if (name && std::ranges::any_of(freedoms.all, is_named)) found = name;
  } else if (const auto position = read_number(*place, model::not_negative)) {
    found = node_at(freedoms, *position, model::shaft_length_m(matrices));
  }
  if (!section.is_sound()) return;
  const yaml::Value& where = node ? *node : *place;
  if (found) {
    unbalance.node = *found;
    matrices.unbalance.push_back(unbalance);
  } else {
    refuse(where, fmt::format("'{}' is no node of the shaft", yaml::shown(where.node.text)),
           "a node of degrees_of_freedom with a position_m");
  }
}

void read_unbalance(const yaml::Value& value, const Freedoms& freedoms, ShaftMatrices& matrices) {
  if (is_still_a_file(value)) return;
  if (value.node.kind != yaml::Node::Kind::list) return read_unbalance_columns(value, freedoms, matrices);
  for (const yaml::Value& item : read_list(value, most)) read_node_unbalance(item, freedoms, matrices);
}

/// Reads the matrices. A matrix that is left out is zero. A needed matrix that is missing or cannot be read
/// is a problem of the file. The unit matrix then takes its place, so that later checks do not add problems
/// that follow from the first one.
void read_matrices(yaml::Section& section, ShaftMatrices& matrices) {
  const auto n = static_cast<Eigen::Index>(matrices.degrees_of_freedom.size());
  for (const MatrixKey& key : matrix_keys) {
    Eigen::MatrixXd& matrix = matrices.*key.matrix;
    matrix = key.needed ? Eigen::MatrixXd(Eigen::MatrixXd::Identity(n, n)) : Eigen::MatrixXd::Zero(n, n);
    const auto value = key.needed ? section.require(key.name, matrix_form) : section.find(key.name);
    if (!value || is_still_a_file(*value)) continue;
    auto read = read_matrix_market(*value);
    if (!read) continue;
    if (read->rows() == n) {
      matrix = *std::move(read);
    } else {
      refuse(*value, fmt::format("is {0} x {0}", read->rows()),
             fmt::format("{0} x {0}, as many as degrees_of_freedom", n));
    }
  }
}

void refuse_problems(yaml::Section& section, const ShaftMatrices& matrices, const Freedoms& freedoms) {
  for (const structure::MatrixProblem& problem : structure::problems_of(matrices)) {
    const bool of_a_row = problem.key == freedoms_key && problem.degree_of_freedom;
    const auto value = of_a_row ? freedoms.rows[*problem.degree_of_freedom] : *section.find(problem.key);
    refuse(value, problem.wrong, problem.allowed);
  }
}

}  // namespace

void resolve_matrices(yaml::Node& root, yaml::Diagnostics& diagnostics) {
  yaml::Node* rotor = child(&root, "rotor");
  const yaml::Node* kind = child(rotor, "kind");
  if (kind == nullptr || kind->text != "matrices") return;
  for (const MatrixKey& key : matrix_keys) {
    if (yaml::Node* matrix = child(rotor, key.name)) resolve_matrix(*matrix, key.name, diagnostics);
  }
  for (const std::string_view key : {freedoms_key, unbalance_key}) {
    if (yaml::Node* table = child(rotor, key))
      resolve_table_file(*table, fmt::format("rotor.{}", key), key_of_table, diagnostics);
  }
}

std::shared_ptr<const ShaftMatrices> read_shaft_matrices(yaml::Section& section) {
  const auto listed = section.require(freedoms_key, freedoms_form);
  const auto unbalance = section.require(unbalance_key, unbalance_form);
  for (const MatrixKey& key : matrix_keys) section.find(key.name);
  const auto freedoms = listed ? read_freedoms(*listed) : std::nullopt;
  if (!freedoms) return nullptr;
  const auto matrices = std::make_shared<ShaftMatrices>();
  matrices->degrees_of_freedom = freedoms->all;
  matrices->unbalance_kg =
      Eigen::VectorXcd::Constant(static_cast<Eigen::Index>(freedoms->all.size()), {unknown, unknown});
  read_matrices(section, *matrices);
  if (unbalance) read_unbalance(*unbalance, *freedoms, *matrices);
  if (section.is_sound()) refuse_problems(section, *matrices, *freedoms);
  return matrices;
}

}  // namespace rubsweep::config::machine
