#include "rubsweep/core/structure/matrix_problems.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/matrix_shaft.hpp"

namespace rubsweep::structure {
namespace {

using model::Direction;

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// Text of a matrix entry: "row 3 (x of node 2), column 5 (y of node 2)".
std::string place_of(const model::ShaftMatrices& matrices, Eigen::Index row, Eigen::Index column) {
  const auto name = [&](Eigen::Index i) {
    const auto& [node, direction, position_m, weight_kg] =
        matrices.degrees_of_freedom[static_cast<std::size_t>(i)];
    return std::to_string(i + 1) + " (" + std::string(to_string(direction)) + " of node " + node + ")";
  };
  return "row " + name(row) + ", column " + name(column);
}

/// Reference size of an entry: the geometric mean of the diagonal entries of its row and column in `scale`.
double size_at(const Eigen::MatrixXd& scale, Eigen::Index i, Eigen::Index k) {
  return std::sqrt(std::abs(scale(i, i) * scale(k, k)));
}

/// Adds a problem for the entry with the largest `excess`, if that is more than rounding relative to `scale`.
template <class Excess>
void refuse_largest(const model::ShaftMatrices& matrices, const std::string& key,
                    const Eigen::MatrixXd& scale, const std::string& wrong, const std::string& allowed,
                    std::vector<MatrixProblem>& problems, Excess excess) {
  const Eigen::Index n = scale.rows();
  double worst = 0;
  Eigen::Index row = 0, column = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const double value = std::abs(excess(i, k));
      if (value <= matrix_rounding * size_at(scale, i, k) || value <= worst) continue;
      worst = value, row = i, column = k;
    }
  }
  if (worst > 0)
    problems.push_back(
        {key, wrong + " by " + number(worst) + " at " + place_of(matrices, row, column), allowed});
}

/// Whether two degrees of freedom move in one plane.
bool in_one_plane(const model::ShaftMatrices& matrices, Eigen::Index i, Eigen::Index k) {
  const auto plane = [&](Eigen::Index at) {
    const Direction along = matrices.degrees_of_freedom[static_cast<std::size_t>(at)].direction;
    return along == Direction::x || along == Direction::ry ? 0 : 1;
  };
  return plane(i) == plane(k);
}

std::vector<MatrixProblem> node_problems(const model::ShaftMatrices& matrices) {
  std::vector<MatrixProblem> problems;
  const auto& all = matrices.degrees_of_freedom;
  for (const MatrixNode& node : nodes_of(matrices)) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].node == node.name && all[i].position_m != node.position_m)
        problems.push_back(
            {"degrees_of_freedom", "gives node " + node.name + " two positions", "one for each node", i});
    }
    for (const auto& [a, b] : {std::pair(Direction::x, Direction::y), {Direction::ry, Direction::rx}}) {
      for (const auto& [there, missing] : {std::pair(a, b), {b, a}}) {
        if (!node.of(there) || node.of(missing)) continue;
        problems.push_back({"degrees_of_freedom",
                            "node " + node.name + " has " + std::string(to_string(there)) + " and no " +
                                std::string(to_string(missing)),
                            "x with y, and rx with ry", static_cast<std::size_t>(*node.of(there))});
      }
    }
    if (node.position_m && !node.of(Direction::x) && !node.of(Direction::y))
      problems.push_back(
          {"degrees_of_freedom", "node " + node.name + " is on the shaft and has neither x nor y",
           "x and y at every node with a position_m",
           static_cast<std::size_t>(node.of(Direction::rx).value_or(node.of(Direction::ry).value_or(0)))});
  }
  return problems;
}

void add_mass_problems(const model::ShaftMatrices& matrices, std::vector<MatrixProblem>& problems) {
  const Eigen::MatrixXd& mass = matrices.mass;
  const std::size_t before = problems.size();
  refuse_largest(matrices, "mass", mass, "is not symmetric", "a symmetric matrix", problems,
                 [&](Eigen::Index i, Eigen::Index k) { return mass(i, k) - mass(k, i); });
  refuse_largest(
      matrices, "mass", mass, "couples the motion in x and in y", "no mass between the two planes", problems,
      [&](Eigen::Index i, Eigen::Index k) { return in_one_plane(matrices, i, k) ? 0.0 : mass(i, k); });
  if (problems.size() > before) return;
  std::vector<Eigen::Index> heavy;
  for (Eigen::Index i = 0; i < mass.rows(); ++i) {
    if (!mass.row(i).isZero(0) || !mass.col(i).isZero(0)) heavy.push_back(i);
  }
  const Eigen::MatrixXd part = mass(heavy, heavy);
  for (std::size_t i = 0; i < heavy.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (part(at, at) > 0) continue;
    problems.push_back(
        {"mass",
         "has " + number(part(at, at)) + " on its diagonal at " + place_of(matrices, heavy[i], heavy[i]),
         "a positive definite matrix"});
    return;
  }
  if (heavy.empty() || !numerics::dense::CholeskyFactors(part).positive_definite())
    problems.push_back(
        {"mass", heavy.empty() ? "is zero" : "is not positive definite: some motion has no kinetic energy",
         "a positive definite matrix"});
}

void add_plane_problems(const model::ShaftMatrices& matrices, const std::string& key,
                        const Eigen::MatrixXd& matrix, std::vector<MatrixProblem>& problems) {
  refuse_largest(matrices, key, matrix, "is not symmetric within one plane",
                 "a matrix that is symmetric but for what couples x and y", problems,
                 [&](Eigen::Index i, Eigen::Index k) {
                   return in_one_plane(matrices, i, k) ? matrix(i, k) - matrix(k, i) : 0.0;
                 });
}

void add_gyroscopic_problems(const model::ShaftMatrices& matrices, const MatrixLayout& layout,
                             std::vector<MatrixProblem>& problems) {
  const Eigen::MatrixXd& turning = matrices.gyroscopic;
  const Eigen::MatrixXd scale =
      Eigen::MatrixXd::Identity(turning.rows(), turning.cols()) * turning.cwiseAbs().maxCoeff();
  const std::size_t before = problems.size();
  refuse_largest(matrices, "gyroscopic", scale, "is not skew-symmetric",
                 "a skew-symmetric matrix, which times the speed in rad/s is added to the damping", problems,
                 [&](Eigen::Index i, Eigen::Index k) { return turning(i, k) + turning(k, i); });
  refuse_largest(matrices, "gyroscopic", scale, "acts within one plane",
                 "numbers between x, ry and y, rx alone", problems, [&](Eigen::Index i, Eigen::Index k) {
                   return in_one_plane(matrices, i, k) ? turning(i, k) : 0.0;
                 });
  if (problems.size() > before) return;
  const Eigen::MatrixXd across = block(turning, layout, 0, 1);
  if (across.trace() < 0)
    problems.push_back(
        {"gyroscopic", "has the sign of a shaft that turns from y to x",
         "that of one that turns from x to y: moments of inertia about the axis stand in the row of "
         "rx and the column of ry, those times -1 in the row of ry"});
  const Asymmetry found = asymmetry_of(across);
  if (found.difference <= matrix_rounding * turning.cwiseAbs().maxCoeff()) return;
  problems.push_back({"gyroscopic",
                      "turns x into y otherwise than y into x, by " + number(found.difference) + " at " +
                          place_of(matrices, *layout.plane[0][static_cast<std::size_t>(found.row)].freedom,
                                   *layout.plane[1][static_cast<std::size_t>(found.column)].freedom),
                      "the same between two places in both orders, as of a round shaft"});
}

}  // namespace

Asymmetry asymmetry_of(const Eigen::MatrixXd& matrix) {
  Asymmetry found;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index k = 0; k < i; ++k) {
      const double difference = std::abs(matrix(i, k) - matrix(k, i));
      if (difference > found.difference) found = {difference, i, k};
    }
  }
  return found;
}

std::vector<MatrixProblem> problems_of(const model::ShaftMatrices& matrices) {
  std::vector<MatrixProblem> problems = node_problems(matrices);
  if (!problems.empty()) return problems;
  const MatrixLayout layout = layout_of(matrices);
  add_mass_problems(matrices, problems);
  add_plane_problems(matrices, "stiffness", matrices.stiffness, problems);
  add_plane_problems(matrices, "damping", matrices.damping, problems);
  add_gyroscopic_problems(matrices, layout, problems);
  if (const auto wrong = turning_unbalance(matrices, layout).wrong) {
    const model::DegreeOfFreedom& one = matrices.degrees_of_freedom[*wrong];
    problems.push_back({"unbalance",
                        "does not turn with the shaft at node " + one.node + ": " +
                            std::string(to_string(one.direction)) + " does not lag a quarter turn behind " +
                            (one.direction == Direction::y ? "x" : "ry, against it"),
                        "y = -i x and rx = i ry, or one plane alone", wrong});
  }
  return problems;
}

}  // namespace rubsweep::structure
