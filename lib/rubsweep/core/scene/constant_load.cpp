#include "rubsweep/core/scene/constant_load.hpp"

#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::scene {
namespace {

bool counts_from_sag(const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  return kit != nullptr && kit->clearances_from_sag;
}

}  // namespace

Eigen::VectorXd static_load_n(const PreparedMachine& prepared) {
  Eigen::VectorXd load = prepared.machine.gravity_m_per_s2 * prepared.assembly.system.weight_kg;
  if (prepared.assembly.static_n.size() > 0) load += prepared.assembly.static_n;
  return load;
}

Eigen::VectorXd constant_load_n(const PreparedMachine& prepared) {
  if (counts_from_sag(prepared.machine)) return Eigen::VectorXd::Zero(prepared.assembly.system.coordinates());
  return static_load_n(prepared);
}

Eigen::VectorXd unloaded_position_m(const PreparedMachine& prepared,
                                    const structure::LinearSystem& structure) {
  const Eigen::VectorXd load = static_load_n(prepared);
  if (!counts_from_sag(prepared.machine) || load.isZero(0)) return Eigen::VectorXd::Zero(load.size());
  return -numerics::dense::solve(structure.stiffness, load);
}

Eigen::Vector2d sag_m(const PreparedMachine& prepared, std::size_t stop) {
  const structure::Assembly& assembly = prepared.assembly;
  const auto& points = assembly.system.points;
  const Eigen::VectorXd load = static_load_n(prepared);
  if (load.isZero(0)) return Eigen::Vector2d::Zero();
  const Eigen::VectorXd q = numerics::dense::solve(assembly.system.stiffness, load);
  Eigen::Vector2d sag = points[static_cast<std::size_t>(assembly.rotor_points[stop])].map * q;
  if (const auto casing = assembly.casing_points[stop])
    sag -= points[static_cast<std::size_t>(*casing)].map * q;
  return sag;
}

}  // namespace rubsweep::scene
