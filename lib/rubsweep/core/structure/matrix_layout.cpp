#include "rubsweep/core/structure/matrix_layout.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

namespace rubsweep::structure {

using model::Direction;

std::vector<MatrixNode> nodes_of(const model::ShaftMatrices& matrices) {
  std::vector<MatrixNode> nodes;
  std::map<std::string, std::size_t> known;
  const auto& all = matrices.degrees_of_freedom;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto [at, is_new] = known.try_emplace(all[i].node, nodes.size());
    if (is_new) nodes.push_back({all[i].node, all[i].position_m, {}});
    nodes[at->second].freedom[static_cast<std::size_t>(all[i].direction)] = static_cast<Eigen::Index>(i);
  }
  std::ranges::stable_sort(nodes, [](const MatrixNode& a, const MatrixNode& b) {
    if (a.position_m && b.position_m) return *a.position_m < *b.position_m;
    return a.position_m.has_value() && !b.position_m.has_value();
  });
  return nodes;
}

MatrixLayout layout_of(const model::ShaftMatrices& matrices) {
  MatrixLayout layout;
  const auto add = [&](const std::optional<Eigen::Index>& x, const std::optional<Eigen::Index>& y,
                       bool sideways) {
    layout.plane[0].push_back({x, 1});
    layout.plane[1].push_back({y, sideways ? 1.0 : -1.0});
  };
  for (const MatrixNode& node : nodes_of(matrices)) {
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

Eigen::MatrixXd block(const Eigen::MatrixXd& matrix, const MatrixLayout& layout, std::size_t a,
                      std::size_t b) {
  const Eigen::Index n = layout.coordinates();
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const PlaneSource &row = layout.plane[a][static_cast<std::size_t>(i)],
                        &column = layout.plane[b][static_cast<std::size_t>(k)];
      if (row.freedom && column.freedom)
        found(i, k) = row.sign * column.sign * matrix(*row.freedom, *column.freedom);
    }
  }
  return found;
}

TurningUnbalance turning_unbalance(const model::ShaftMatrices& matrices, const MatrixLayout& layout) {
  const std::complex<double> i(0, 1);
  TurningUnbalance turning{Eigen::VectorXcd::Zero(layout.coordinates()), std::nullopt};
  double largest = 0;
  for (const auto& value : matrices.unbalance_kg) {
    if (!std::isnan(value.real())) largest = std::max(largest, std::abs(value));
  }
  for (Eigen::Index k = 0; k < layout.coordinates(); ++k) {
    const PlaneSource &x = layout.plane[0][static_cast<std::size_t>(k)],
                      &y = layout.plane[1][static_cast<std::size_t>(k)];
    if (!x.freedom || !y.freedom) continue;
    const std::complex<double> in_x = matrices.unbalance_kg(*x.freedom),
                               in_y = y.sign * i * matrices.unbalance_kg(*y.freedom);
    const bool no_x = std::isnan(in_x.real()), no_y = std::isnan(matrices.unbalance_kg(*y.freedom).real());
    if (!no_x && !no_y && std::abs(in_x - in_y) > matrix_rounding * largest && !turning.wrong)
      turning.wrong = static_cast<std::size_t>(*y.freedom);
    if (!no_x || !no_y) turning.kg(k) = no_x ? in_y : in_x;
  }
  return turning;
}

}  // namespace rubsweep::structure
