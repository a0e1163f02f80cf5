#include "rubsweep/structure/matrix_shaft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "rubsweep/error.hpp"
#include "rubsweep/numerics/cholesky.hpp"

namespace rubsweep::structure {
namespace {

using model::Direction;

constexpr double rounding = 1e-9;  ///< of what stands on the diagonal

/// Degree of freedom behind a coordinate of one plane; the angle about x counts the other way.
struct Source {
  std::optional<Eigen::Index> freedom;
  double sign = 1;
};

/// The coordinates of a beam shaft and where they come from.
struct Layout {
  std::vector<double> node_position_m;
  std::array<std::vector<Source>, 2> plane;  ///< n each
  std::vector<bool> moves_sideways;          ///< n: a displacement, no angle
  std::vector<Eigen::Index> bodies;          ///< coordinates beside the shaft

  Eigen::Index coordinates() const { return static_cast<Eigen::Index>(plane[0].size()); }
};

/// All directions of one node by their numbers.
struct Node {
  std::string name;
  std::optional<double> position_m;
  std::array<std::optional<Eigen::Index>, 4> freedom;

  const std::optional<Eigen::Index>& of(Direction direction) const {
    return freedom[static_cast<std::size_t>(direction)];
  }
};

/// Nodes on the shaft by their position, those of one place in the order of the table; then the others.
std::vector<Node> nodes_of(const model::ShaftMatrices& matrices) {
  std::vector<Node> nodes;
  std::map<std::string, std::size_t> known;
  const auto& all = matrices.degrees_of_freedom;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [at, is_new] = known.try_emplace(all[i].node, nodes.size());
    if (is_new) nodes.push_back({all[i].node, all[i].position_m, {}});
    nodes[at->second].freedom[static_cast<std::size_t>(all[i].direction)] = static_cast<Eigen::Index>(i);
  }
  std::ranges::stable_sort(nodes, [](const Node& a, const Node& b) {
    if (a.position_m && b.position_m) return *a.position_m < *b.position_m;
    return a.position_m.has_value() && !b.position_m.has_value();
  });
  return nodes;
}

Layout layout_of(const model::ShaftMatrices& matrices) {
  Layout layout;
  const auto add = [&](const std::optional<Eigen::Index>& x, const std::optional<Eigen::Index>& y,
                       bool sideways) {
    layout.plane[0].push_back({x, 1});
    layout.plane[1].push_back({y, sideways ? 1.0 : -1.0});
    layout.moves_sideways.push_back(sideways);
  };
  for (const Node& node : nodes_of(matrices)) {
    const bool on_shaft = node.position_m.has_value();
    if (on_shaft) layout.node_position_m.push_back(*node.position_m);
    const Eigen::Index first = layout.coordinates();
    if (on_shaft || node.of(Direction::x)) add(node.of(Direction::x), node.of(Direction::y), true);
    if (on_shaft || node.of(Direction::ry)) add(node.of(Direction::ry), node.of(Direction::rx), false);
    if (!on_shaft) {
      for (Eigen::Index i = first; i < layout.coordinates(); ++i) layout.bodies.push_back(i);
    }
  }
  return layout;
}

/// The block of a matrix between the motions of two planes.
Eigen::MatrixXd block(const Eigen::MatrixXd& matrix, const Layout& layout, std::size_t a, std::size_t b) {
  const Eigen::Index n = layout.coordinates();
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const Source &row = layout.plane[a][static_cast<std::size_t>(i)],
                   &column = layout.plane[b][static_cast<std::size_t>(k)];
      if (row.freedom && column.freedom)
        found(i, k) = row.sign * column.sign * matrix(*row.freedom, *column.freedom);
    }
  }
  return found;
}

/// Frees a matrix that was found symmetric of what rounding has left; one that is keeps its bits.
Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) { return (matrix + matrix.transpose()) / 2; }

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// "row 3 (x of node 2), column 5 (y of node 2)".
std::string place_of(const model::ShaftMatrices& matrices, Eigen::Index row, Eigen::Index column) {
  const auto name = [&](Eigen::Index i) {
    const auto& [node, direction, position_m, weight_kg] =
        matrices.degrees_of_freedom[static_cast<std::size_t>(i)];
    return std::to_string(i + 1) + " (" + std::string(to_string(direction)) + " of node " + node + ")";
  };
  return "row " + name(row) + ", column " + name(column);
}

/// Size that an entry is small or large against: what its own row and column have on the diagonals of
/// `scale`.
double size_at(const Eigen::MatrixXd& scale, Eigen::Index i, Eigen::Index k) {
  return std::sqrt(std::abs(scale(i, i) * scale(k, k)));
}

/// Adds the entry of a matrix that `excess` finds most too large against `scale`, with the words of the
/// caller.
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
      if (value <= rounding * size_at(scale, i, k) || value <= worst) continue;
      worst = value, row = i, column = k;
    }
  }
  if (worst > 0)
    problems.push_back(
        {key, wrong + " by " + number(worst) + " at " + place_of(matrices, row, column), allowed});
}

std::size_t plane_of(const model::DegreeOfFreedom& one) {
  return one.direction == Direction::x || one.direction == Direction::ry ? 0 : 1;
}

std::vector<MatrixProblem> node_problems(const model::ShaftMatrices& matrices) {
  std::vector<MatrixProblem> problems;
  const auto& all = matrices.degrees_of_freedom;
  for (const Node& node : nodes_of(matrices)) {
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
  const auto& all = matrices.degrees_of_freedom;
  const auto apart = [&](Eigen::Index i, Eigen::Index k) {
    return plane_of(all[static_cast<std::size_t>(i)]) != plane_of(all[static_cast<std::size_t>(k)]);
  };
  const std::size_t before = problems.size();
  refuse_largest(matrices, "mass", mass, "is not symmetric", "a symmetric matrix", problems,
                 [&](Eigen::Index i, Eigen::Index k) { return mass(i, k) - mass(k, i); });
  refuse_largest(matrices, "mass", mass, "couples the motion in x and in y", "no mass between the two planes",
                 problems, [&](Eigen::Index i, Eigen::Index k) { return apart(i, k) ? mass(i, k) : 0.0; });
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
  if (heavy.empty() || !numerics::CholeskyFactors(part).positive_definite())
    problems.push_back(
        {"mass", heavy.empty() ? "is zero" : "is not positive definite: some motion has no kinetic energy",
         "a positive definite matrix"});
}

void add_plane_problems(const model::ShaftMatrices& matrices, const std::string& key,
                        const Eigen::MatrixXd& matrix, std::vector<MatrixProblem>& problems) {
  const auto& all = matrices.degrees_of_freedom;
  refuse_largest(matrices, key, matrix, "is not symmetric within one plane",
                 "a matrix that is symmetric but for what couples x and y", problems,
                 [&](Eigen::Index i, Eigen::Index k) {
                   return plane_of(all[static_cast<std::size_t>(i)]) ==
                                  plane_of(all[static_cast<std::size_t>(k)])
                              ? matrix(i, k) - matrix(k, i)
                              : 0.0;
                 });
}

void add_gyroscopic_problems(const model::ShaftMatrices& matrices, const Layout& layout,
                             std::vector<MatrixProblem>& problems) {
  const Eigen::MatrixXd& turning = matrices.gyroscopic;
  const Eigen::MatrixXd scale =
      Eigen::MatrixXd::Identity(turning.rows(), turning.cols()) * turning.cwiseAbs().maxCoeff();
  const auto& all = matrices.degrees_of_freedom;
  const std::size_t before = problems.size();
  refuse_largest(matrices, "gyroscopic", scale, "is not skew-symmetric",
                 "a skew-symmetric matrix, which times the speed in rad/s is added to the damping", problems,
                 [&](Eigen::Index i, Eigen::Index k) { return turning(i, k) + turning(k, i); });
  refuse_largest(matrices, "gyroscopic", scale, "acts within one plane",
                 "numbers between x, ry and y, rx alone", problems, [&](Eigen::Index i, Eigen::Index k) {
                   return plane_of(all[static_cast<std::size_t>(i)]) ==
                                  plane_of(all[static_cast<std::size_t>(k)])
                              ? turning(i, k)
                              : 0.0;
                 });
  if (problems.size() > before) return;
  const Eigen::MatrixXd across = block(turning, layout, 0, 1);
  const Asymmetry found = asymmetry_of(across);
  if (found.difference <= rounding * turning.cwiseAbs().maxCoeff()) return;
  problems.push_back({"gyroscopic",
                      "turns x into y otherwise than y into x, by " + number(found.difference) + " at " +
                          place_of(matrices, *layout.plane[0][static_cast<std::size_t>(found.row)].freedom,
                                   *layout.plane[1][static_cast<std::size_t>(found.column)].freedom),
                      "the same between two places in both orders, as of a round shaft"});
}

/// The unbalance in the x plane; empty with the number of the degree of freedom that does not turn with it.
struct Turning {
  Eigen::VectorXcd kg;
  std::optional<std::size_t> wrong;
};

Turning turning_unbalance(const model::ShaftMatrices& matrices, const Layout& layout) {
  const std::complex<double> i(0, 1);
  Turning turning{Eigen::VectorXcd::Zero(layout.coordinates()), std::nullopt};
  double largest = 0;
  for (const auto& value : matrices.unbalance_kg) {
    if (!std::isnan(value.real())) largest = std::max(largest, std::abs(value));
  }
  for (Eigen::Index k = 0; k < layout.coordinates(); ++k) {
    const Source &x = layout.plane[0][static_cast<std::size_t>(k)],
                 &y = layout.plane[1][static_cast<std::size_t>(k)];
    if (!x.freedom || !y.freedom) continue;
    const std::complex<double> in_x = matrices.unbalance_kg(*x.freedom),
                               in_y = y.sign * i * matrices.unbalance_kg(*y.freedom);
    const bool no_x = std::isnan(in_x.real()), no_y = std::isnan(matrices.unbalance_kg(*y.freedom).real());
    if (!no_x && !no_y && std::abs(in_x - in_y) > rounding * largest && !turning.wrong)
      turning.wrong = static_cast<std::size_t>(*y.freedom);
    if (!no_x || !no_y) turning.kg(k) = no_x ? in_y : in_x;
  }
  return turning;
}

void add_node_unbalance(const model::ShaftMatrices& matrices, BeamShaft& shaft) {
  for (const model::NodeUnbalance& one : matrices.unbalance) {
    const auto& all = matrices.degrees_of_freedom;
    const auto at = std::ranges::find(all, one.node, &model::DegreeOfFreedom::node);
    shaft.unbalance_kg(shaft.deflection(at->position_m.value())) +=
        std::polar(one.mass_kg * one.eccentricity_ratio, one.phase_deg * std::numbers::pi / 180);
  }
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
  const Layout layout = layout_of(matrices);
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

BeamShaft matrix_shaft(const model::ShaftMatrices& matrices) {
  if (const auto problems = problems_of(matrices); !problems.empty())
    throw ConfigError("rotor." + problems.front().key + ": " + problems.front().wrong +
                      ", allowed: " + problems.front().allowed);
  const Layout layout = layout_of(matrices);
  const Eigen::Index n = layout.coordinates();
  BeamShaft shaft;
  shaft.node_position_m = layout.node_position_m;
  shaft.mass = shaft.damping = shaft.elastic = Eigen::MatrixXd::Zero(n, n);
  shaft.gyroscopic = symmetric_part(block(matrices.gyroscopic, layout, 0, 1));
  for (std::size_t a = 0; a < 2; ++a) {
    const std::size_t b = 1 - a;
    shaft.added_mass[a] = symmetric_part(block(matrices.mass, layout, a, a));
    shaft.support_stiffness[a][a] = symmetric_part(block(matrices.stiffness, layout, a, a));
    shaft.support_damping[a][a] = symmetric_part(block(matrices.damping, layout, a, a));
    shaft.support_stiffness[a][b] = block(matrices.stiffness, layout, a, b);
    shaft.support_damping[a][b] = block(matrices.damping, layout, a, b);
  }
  const Eigen::VectorXd weight = model::weight_kg(matrices);
  shaft.weight_kg = Eigen::VectorXd::Zero(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Source& y = layout.plane[1][static_cast<std::size_t>(k)];
    if (y.freedom) {
      shaft.weight_kg(k) = y.sign * weight(*y.freedom);
    } else {
      for (std::size_t a = 0; a < 2; ++a) shaft.support_stiffness[a][a](k, k) = 1;
    }
  }
  shaft.housings = layout.bodies;
  shaft.unbalance_kg = turning_unbalance(matrices, layout).kg;
  add_node_unbalance(matrices, shaft);
  return shaft;
}

}  // namespace rubsweep::structure
