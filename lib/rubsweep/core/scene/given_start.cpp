#include "rubsweep/core/scene/given_start.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/constant_load.hpp"

namespace rubsweep::scene {
namespace {

constexpr double largest_miss = 1e-6;  ///< largest error, as a share of the wanted value

/// Rows of the structure's points, and the wanted values of their products with the state.
struct Wanted {
  std::vector<std::pair<Eigen::RowVectorXd, double>> rows;

  void add(const Eigen::RowVectorXd& row, const std::optional<double>& value) {
    if (value) rows.emplace_back(row, *value);
  }
};

/// State changed to have the wanted values, by forces or impulses along the rows. `matrix` is the stiffness
/// for forces, the mass for impulses.
Eigen::VectorXd brought_to(const Wanted& wanted, const Eigen::VectorXd& state,
                           const Eigen::MatrixXd& matrix) {
  if (wanted.rows.empty()) return state;
  const auto count = static_cast<Eigen::Index>(wanted.rows.size());
  Eigen::MatrixXd rows(count, state.size());
  Eigen::VectorXd values(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& [row, value] = wanted.rows[static_cast<std::size_t>(i)];
    rows.row(i) = row;
    values(i) = value;
  }
  const Eigen::MatrixXd shapes =
      numerics::dense::least_norm_solution(matrix, Eigen::MatrixXd(rows.transpose()));
  const Eigen::VectorXd missing = values - rows * state;
  const Eigen::VectorXd changed =
      state + shapes * numerics::dense::least_norm_solution(Eigen::MatrixXd(rows * shapes), missing);
  if (!((rows * changed - values).norm() <= largest_miss * missing.norm()))
    throw ConfigError("start: the structure cannot be brought there, allowed: points that move freely");
  return changed;
}

}  // namespace

void start_in_given_state(Scene& scene, const PreparedMachine& prepared) {
  if (!prepared.machine.start) return;
  if (prepared.machine.start->at_rest) {
    scene.displacement_m = unloaded_position_m(prepared, scene.structure);
    scene.velocity_m_per_s.setZero(scene.displacement_m.size());
    return;
  }
  const structure::Assembly& assembly = prepared.assembly;
  Wanted displacement, velocity;
  const auto add = [&](const model::BodyState& state, int point) {
    const auto& map = assembly.system.points[static_cast<std::size_t>(point)].map;
    displacement.add(map.row(0), state.x_m);
    displacement.add(map.row(1), state.y_m);
    velocity.add(map.row(0), state.vx_m_per_s);
    velocity.add(map.row(1), state.vy_m_per_s);
  };
  const model::Start& start = *prepared.machine.start;
  add(start.rotor, assembly.observed_point);
  for (std::size_t i = 0; i < start.casings.size(); ++i) {
    if (start.casings[i]) add(*start.casings[i], *assembly.casing_points[i]);
  }
  scene.displacement_m = brought_to(displacement, scene.displacement_m, assembly.system.stiffness);
  scene.velocity_m_per_s = brought_to(velocity, scene.velocity_m_per_s, assembly.system.mass);
}

}  // namespace rubsweep::scene
