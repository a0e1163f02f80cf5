#include "rubsweep/maps/report/explain_matrices.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/core/structure/matrix_problems.hpp"

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

}  // namespace rubsweep::report
