#include "rubsweep/core/structure/matrix_shaft.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/structure/matrix_problems.hpp"

namespace rubsweep::structure {
namespace {

/// Removes rounding from a matrix that is known to be symmetric; an exactly symmetric one keeps its bits.
Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& matrix) { return (matrix + matrix.transpose()) / 2; }

void add_node_unbalance(const model::ShaftMatrices& matrices, BeamShaft& shaft) {
  for (const model::NodeUnbalance& one : matrices.unbalance) {
    const auto& all = matrices.degrees_of_freedom;
    const auto at = std::ranges::find(all, one.node, &model::DegreeOfFreedom::node);
    shaft.unbalance_kg(shaft.deflection(at->position_m.value())) +=
        std::polar(one.mass_kg * one.eccentricity_ratio, one.phase_deg * std::numbers::pi / 180);
  }
}

using model::Direction;

void refuse(const std::string& key, const std::string& wrong, const std::string& allowed) {
  throw ConfigError(key + ": " + wrong + " and cannot be said by matrices, allowed: " + allowed);
}

bool stays_a_support(const model::Support& support) { return support.table || support.fault; }

void refuse_what_matrices_cannot_say(const model::RotorKit& kit) {
  if (kit.bow) refuse("rotor.bow", "is a line of the shaft without load", "no bow");
  if (kit.torsion) refuse("rotor.torsion", "is no lateral motion", "no torsion");
  if (model::has_misalignment(kit)) refuse("rotor.couplings", "join ends out of line", "couplings in line");
  if (model::has_standing_misalignment(kit))
    refuse("rotor.couplings", "join machines out of line", "machines in line");
  if (std::ranges::any_of(kit.couplings, model::is_asymmetric))
    refuse("rotor.couplings", "have an asymmetry ratio", "couplings that are equally stiff all around");
  for (std::size_t i = 0; i < kit.supports.size(); ++i) {
    const model::Support& support = kit.supports[i];
    if (stays_a_support(support) && (support.at_housing || support.on_housing))
      refuse(model::support_path(kit, i), "follows a table or strikes the shaft beside a housing",
             "such a support of the shaft on the ground or a pedestal");
  }
}

/// Coordinates of a beam shaft in the order of the exported degrees of freedom.
struct Exported {
  model::ShaftMatrices matrices;
  /// plane and coordinate of every degree of freedom
  std::vector<std::pair<std::size_t, Eigen::Index>> source;
  std::vector<double> sign;

  void add(const std::string& node, Direction direction, std::optional<double> position_m,
           Eigen::Index coordinate) {
    matrices.degrees_of_freedom.push_back({node, direction, position_m, {}});
    source.emplace_back(direction == Direction::x || direction == Direction::ry ? 0 : 1, coordinate);
    sign.push_back(direction == Direction::rx ? -1 : 1);
  }
};

Exported degrees_of_freedom_of(const BeamShaft& shaft) {
  Exported exported;
  const std::size_t nodes = shaft.node_position_m.size();
  for (std::size_t i = 0; i < nodes; ++i) {
    const auto w = static_cast<Eigen::Index>(2 * i);
    const std::string name = std::to_string(i + 1);
    for (const auto& [direction, coordinate] :
         {std::pair(Direction::x, w), {Direction::y, w}, {Direction::rx, w + 1}, {Direction::ry, w + 1}})
      exported.add(name, direction, shaft.node_position_m[i], coordinate);
  }
  for (auto body = static_cast<Eigen::Index>(2 * nodes); body < shaft.coordinates(); ++body) {
    const std::string name = std::to_string(nodes + 1 + static_cast<std::size_t>(body) - 2 * nodes);
    exported.add(name, Direction::x, {}, body);
    exported.add(name, Direction::y, {}, body);
  }
  return exported;
}

model::ShaftMatrices matrices_of(const BeamShaft& shaft) {
  Exported exported = degrees_of_freedom_of(shaft);
  model::ShaftMatrices& matrices = exported.matrices;
  const auto n = static_cast<Eigen::Index>(exported.sign.size());
  matrices.mass = matrices.damping = matrices.gyroscopic = matrices.stiffness = Eigen::MatrixXd::Zero(n, n);
  matrices.unbalance_kg = Eigen::VectorXcd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto [a, row] = exported.source[static_cast<std::size_t>(i)];
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto [b, column] = exported.source[static_cast<std::size_t>(k)];
      const double sign =
          exported.sign[static_cast<std::size_t>(i)] * exported.sign[static_cast<std::size_t>(k)];
      if (a == b) {
        // The same sums as in plane_mass and plane_stiffness, so that all bits agree.
        matrices.mass(i, k) = sign * (shaft.mass(row, column) + shaft.added_mass[a](row, column));
        matrices.stiffness(i, k) =
            sign * (shaft.elastic(row, column) + shaft.support_stiffness[a][a](row, column));
        matrices.damping(i, k) =
            sign * (shaft.damping(row, column) + shaft.support_damping[a][a](row, column));
      } else {
        matrices.stiffness(i, k) = sign * shaft.support_stiffness[a][b](row, column);
        matrices.damping(i, k) = sign * shaft.support_damping[a][b](row, column);
        matrices.gyroscopic(i, k) = (a == 0 ? sign : -sign) * shaft.gyroscopic(row, column);
      }
    }
    const std::complex<double> lag = a == 0 ? std::complex<double>(1, 0) : std::complex<double>(0, -1);
    matrices.unbalance_kg(i) = exported.sign[static_cast<std::size_t>(i)] * lag * shaft.unbalance_kg(row);
  }
  const Eigen::VectorXd by_mass = model::weight_kg(matrices);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto [plane, row] = exported.source[static_cast<std::size_t>(i)];
    const double weight = plane == 0 ? 0 : exported.sign[static_cast<std::size_t>(i)] * shaft.weight_kg(row);
    if (weight != by_mass(i)) matrices.degrees_of_freedom[static_cast<std::size_t>(i)].weight_kg = weight;
  }
  return matrices;
}

}  // namespace

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

BeamShaft matrix_shaft(const model::ShaftMatrices& matrices) {
  if (const auto problems = problems_of(matrices); !problems.empty())
    throw ConfigError("rotor." + problems.front().key + ": " + problems.front().wrong +
                      ", allowed: " + problems.front().allowed);
  const MatrixLayout layout = layout_of(matrices);
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
    const PlaneSource& y = layout.plane[1][static_cast<std::size_t>(k)];
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

model::Machine machine_by_matrices(const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr)
    throw ConfigError("rotor.kind: a Jeffcott rotor has no finite elements, allowed: a rotor kit");
  if (kit->matrices) return machine;
  refuse_what_matrices_cannot_say(*kit);
  model::RotorKit held = *kit, by_matrices = *kit;
  std::erase_if(held.supports, stays_a_support);
  std::erase_if(by_matrices.supports,
                [](const model::Support& support) { return !stays_a_support(support); });
  std::vector<double> stations_m;
  for (const model::Stop& stop : machine.stops) stations_m.push_back(stop.position_m.value());
  model::for_each_kick(machine, [&](const model::Kick& kick, auto) {
    if (kick.position_m) stations_m.push_back(*kick.position_m);
  });
  for (const model::Support& support : by_matrices.supports) stations_m.push_back(support.position_m);
  by_matrices.matrices =
      std::make_shared<model::ShaftMatrices>(matrices_of(assemble_beam_shaft(held, stations_m)));
  by_matrices.shaft.clear();
  by_matrices.discs.clear();
  by_matrices.point_masses.clear();
  by_matrices.housings.clear();
  by_matrices.couplings.clear();
  by_matrices.mass_damping_per_s = 0;
  model::Machine exported = machine;
  exported.rotor = std::move(by_matrices);
  return exported;
}

}  // namespace rubsweep::structure
