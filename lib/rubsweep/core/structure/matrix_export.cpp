#include "rubsweep/core/structure/matrix_export.hpp"

#include <algorithm>
#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/support_path.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {
namespace {

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
  std::vector<std::pair<std::size_t, Eigen::Index>> source;  ///< plane and coordinate
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
        // The sums that plane_mass and its like make of the same numbers: no bit differs.
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
  if (machine.kick && machine.kick->position_m) stations_m.push_back(*machine.kick->position_m);
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
