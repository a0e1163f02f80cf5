#include "rubsweep/maps/config/machine/printed_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/machine/matrix_market.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"

namespace rubsweep::config::machine {
namespace {

/// Row of the table of unbalances.
struct UnbalanceRow {
  const model::DegreeOfFreedom* at;
  double real_kg, imaginary_kg;
};

/// Rows of the degrees of freedom that have an unbalance. At least one row, since a table may not be empty.
std::vector<UnbalanceRow> unbalance_rows(const model::ShaftMatrices& matrices) {
  std::vector<UnbalanceRow> rows;
  for (std::size_t i = 0; i < matrices.degrees_of_freedom.size(); ++i) {
    const auto value = matrices.unbalance_kg(static_cast<Eigen::Index>(i));
    if (!std::isnan(value.real()))
      rows.push_back({&matrices.degrees_of_freedom[i], value.real() + 0.0, value.imag() + 0.0});
  }
  if (rows.empty()) rows.push_back({&matrices.degrees_of_freedom.front(), 0, 0});
  return rows;
}

bool has_weights(const model::ShaftMatrices& matrices) {
  return std::ranges::any_of(matrices.degrees_of_freedom,
                             [](const model::DegreeOfFreedom& one) { return one.weight_kg.has_value(); });
}

std::string cell(const std::optional<double>& value, std::string_view nothing) {
  return value ? fmt::format("{}", *value) : std::string(nothing);
}

template <class Items, class Text>
std::string listed(const Items& items, Text text) {
  std::string list;
  for (const auto& item : items) list += fmt::format("{}{}", list.empty() ? "" : ", ", text(item));
  return fmt::format("[{}]", list);
}

void print_freedoms(yaml::Printer& printer, const model::ShaftMatrices& matrices) {
  const auto& all = matrices.degrees_of_freedom;
  std::vector<std::string> nodes(all.size());
  std::ranges::transform(all, nodes.begin(), &model::DegreeOfFreedom::node);
  printer.open(freedoms_key);
  printer.texts("node", nodes);
  printer.word("direction", listed(all, [](const auto& one) { return to_string(one.direction); }));
  printer.word("position_m", listed(all, [](const auto& one) { return cell(one.position_m, no_place); }));
  if (has_weights(matrices))
    printer.word("weight_kg", listed(all, [](const auto& one) { return cell(one.weight_kg, no_place); }));
  printer.close();
}

void print_unbalance(yaml::Printer& printer, const model::ShaftMatrices& matrices) {
  printer.open(unbalance_key);
  for (const model::NodeUnbalance& one : matrices.unbalance) {
    printer.open_item();
    printer.text("node", one.node);
    printer.number("mass_kg", one.mass_kg);
    printer.number("eccentricity_ratio", one.eccentricity_ratio);
    printer.number("phase_deg", one.phase_deg);
    printer.close();
  }
  if (matrices.unbalance.empty()) {
    const std::vector<UnbalanceRow> rows = unbalance_rows(matrices);
    std::vector<std::string> nodes(rows.size());
    std::ranges::transform(rows, nodes.begin(), [](const UnbalanceRow& row) { return row.at->node; });
    printer.texts("node", nodes);
    printer.word("direction", listed(rows, [](const auto& row) { return to_string(row.at->direction); }));
    printer.word("real_kg", listed(rows, [](const auto& row) { return cell(row.real_kg, ""); }));
    printer.word("imaginary_kg", listed(rows, [](const auto& row) { return cell(row.imaginary_kg, ""); }));
  }
  printer.close();
}

}  // namespace

void print_shaft_matrices(yaml::Printer& printer, const model::ShaftMatrices& matrices, MatrixPrint how) {
  const auto files = matrix_files(matrices);
  for (const MatrixKey& key : matrix_keys) {
    const std::string name = std::string(key.name) + ".mtx";
    if (how == MatrixPrint::as_files) {
      printer.word(key.name, fmt::format("{{file: {}}}", name));
    } else if (key.needed || !(matrices.*key.matrix).isZero(0)) {
      printer.block(key.name, files.at(name));
    }
  }
  if (how == MatrixPrint::inside) {
    print_freedoms(printer, matrices);
    print_unbalance(printer, matrices);
    return;
  }
  for (const std::string_view key : {freedoms_key, unbalance_key})
    printer.word(key, fmt::format("{{file: {}.csv}}", key));
}

std::map<std::string_view, std::string> matrix_files(const model::ShaftMatrices& matrices) {
  std::map<std::string_view, std::string> files{
      {"mass.mtx", matrix_market(matrices.mass)},
      {"stiffness.mtx", matrix_market(matrices.stiffness)},
      {"damping.mtx", matrix_market(matrices.damping)},
      {"gyroscopic.mtx", matrix_market(matrices.gyroscopic)},
  };
  const bool weights = has_weights(matrices);
  std::string freedoms = weights ? "node,direction,position_m,weight_kg\n" : "node,direction,position_m\n";
  for (const model::DegreeOfFreedom& one : matrices.degrees_of_freedom)
    freedoms += fmt::format("{},{},{}{}{}\n", one.node, to_string(one.direction), cell(one.position_m, ""),
                            weights ? "," : "", weights ? cell(one.weight_kg, "") : "");
  std::string unbalance = "node,direction,real_kg,imaginary_kg\n";
  for (const UnbalanceRow& row : unbalance_rows(matrices))
    unbalance += fmt::format("{},{},{},{}\n", row.at->node, to_string(row.at->direction), row.real_kg,
                             row.imaginary_kg);
  files["degrees_of_freedom.csv"] = std::move(freedoms);
  files["unbalance.csv"] = std::move(unbalance);
  return files;
}

}  // namespace rubsweep::config::machine
