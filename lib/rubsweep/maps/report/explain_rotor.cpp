#include "rubsweep/maps/report/explain_rotor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/model/support_path.hpp"
#include "rubsweep/core/structure/matrix_problems.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::report {
namespace {

std::string name_of(const model::DegreeOfFreedom& one) {
  return fmt::format("{} of node {}", to_string(one.direction), one.node);
}

/// Whether a matrix has one and the same number for both orders of two places.
std::string explain_symmetry(const model::ShaftMatrices& matrices, std::string_view name,
                             const Eigen::MatrixXd& matrix) {
  if (matrix.isZero(0)) return fmt::format("  {}: none\n", name);
  const structure::Asymmetry found = structure::asymmetry_of(matrix);
  constexpr double rounding = 1e-9;
  if (found.difference <= rounding * matrix.cwiseAbs().maxCoeff())
    return fmt::format("  {}: symmetric\n", name);
  const auto& all = matrices.degrees_of_freedom;
  return fmt::format(
      "  {}: not symmetric, most between {} and {}, by {:.6g}; such a rotor can whirl up by itself\n", name,
      name_of(all[static_cast<std::size_t>(found.row)]), name_of(all[static_cast<std::size_t>(found.column)]),
      found.difference);
}

std::size_t massless(const model::ShaftMatrices& matrices) {
  std::size_t count = 0;
  for (Eigen::Index i = 0; i < matrices.mass.rows(); ++i) {
    if (matrices.mass.row(i).isZero(0)) ++count;
  }
  return count;
}

/// Its name in the file that it was read from.
std::string named(const model::Support& support) {
  return support.name.empty() ? "" : " (" + support.name + ")";
}

std::string place_of(const model::Support& support) {
  return support.at_housing ? fmt::format("housing {}", *support.at_housing)
                            : fmt::format("{:.6g} m", support.position_m);
}

std::string explain_coefficients(const model::SupportTable& table, double speed_hz) {
  const structure::SupportCurves curves = structure::curves_of(table);
  std::string text = fmt::format("    at {}:", model::speed_text(speed_hz));
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const bool none = std::ranges::all_of(table.columns[c], [](double value) { return value == 0; });
    if (!none) text += fmt::format(" {} {:.6g}", model::support_coefficients[c], curves[c](speed_hz));
  }
  return text + "\n";
}

}  // namespace

std::string explain_matrices(const model::RotorKit& kit) {
  const model::ShaftMatrices& matrices = *kit.matrices;
  std::set<std::string_view> on_shaft, beside;
  for (const model::DegreeOfFreedom& one : matrices.degrees_of_freedom)
    (one.position_m ? on_shaft : beside).insert(one.node);
  std::string text = fmt::format(
      "rotor: matrices of {} degrees of freedom at {} nodes along {:.6g} m{}, {:.6g} kg; {} supports beside "
      "them\n",
      matrices.degrees_of_freedom.size(), on_shaft.size(), model::shaft_length_m(matrices),
      beside.empty() ? "" : fmt::format(" and {} bodies", beside.size()), model::rotor_mass_kg(matrices),
      kit.supports.size());
  if (const std::size_t count = massless(matrices); count > 0)
    text += fmt::format("  mass: positive definite, but for {} degrees of freedom without any\n", count);
  text += explain_symmetry(matrices, "stiffness", matrices.stiffness);
  text += explain_symmetry(matrices, "damping", matrices.damping);
  text += fmt::format("  gyroscopic: {}\n",
                      matrices.gyroscopic.isZero(0) ? "none" : "skew-symmetric, times the speed");
  return text;
}

std::string explain_tables(const model::Machine& machine, std::vector<double> speeds_hz) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || !model::has_tables(*kit)) return "";
  std::ranges::sort(speeds_hz);
  std::vector<double> shown{speeds_hz.front(), speeds_hz[speeds_hz.size() / 2], speeds_hz.back()};
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  std::string text = "supports that follow the speed (N/m, N s/m, kg), a cell has those of its own speed:\n";
  for (std::size_t i = 0; i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (!table) continue;
    text += fmt::format("  support {}{} at {}: table of {} speeds from {}, monotone cubics between\n", i,
                        named(kit->supports[i]), place_of(kit->supports[i]), table->speed_hz.size(),
                        model::speed_range_text(table->speed_hz.front(), table->speed_hz.back()));
    for (const double speed_hz : shown) text += explain_coefficients(*table, speed_hz);
  }
  return text;
}

std::string describe_sparse_tables(const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  std::string text;
  for (std::size_t i = 0; kit != nullptr && i < kit->supports.size(); ++i) {
    const auto& table = kit->supports[i].table;
    if (table && table->speed_hz.size() < model::SupportTable::enough_points)
      text += fmt::format(
          "{}.table: has {} speeds, which leaves the curve between them to chance; {} or "
          "more are better\n",
          model::support_path(*kit, i), table->speed_hz.size(), model::SupportTable::enough_points);
  }
  return text;
}

std::string describe_many_modes(const scene::PreparedMachine& prepared) {
  // The exact solver's work at every step grows with them.
  constexpr std::size_t many = 12;
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit == nullptr || !prepared.reduction || !prepared.reduction->automatic) return "";
  const auto& numbers = prepared.reduction->mode_number;
  const std::size_t most = std::max(numbers[0].size(), numbers[1].size());
  if (most <= many) return "";
  return fmt::format(
      "modes: auto keeps {} modes a plane, and a cell takes longer with each; a smaller rotor.modes_up_to_hz "
      "(now {}) "
      "or a number as rotor.modes keeps fewer",
      most, kit->modes_up_to_hz);
}

}  // namespace rubsweep::report
