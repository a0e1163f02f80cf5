#include "rubsweep/integrate/run/scaled_system.hpp"

#include <Eigen/Cholesky>
#include <numbers>

#include "rubsweep/error.hpp"
#include "rubsweep/scene/quiet_motion.hpp"

namespace rubsweep::integrate::run {
namespace {

using MassFactor = Eigen::LDLT<Eigen::MatrixXd>;

template <int N>
ScaledContact<N> scale_contact(const scene::Contact& contact, const scene::Scene& scene,
                               const MassFactor& mass) {
  const double length = scene.length_scale_m;
  const double speed = scene.speed_rad_per_s;
  const auto relative = scene::relative_map(scene.structure, contact);
  const Eigen::Vector2d first = contact::first_direction(contact.wall);
  const Eigen::Vector2d second(-first.y(), first.x());
  // A force f on the casing acts on the coordinates as -relative^T f.
  const Eigen::MatrixXd push = -mass.solve(Eigen::MatrixXd(relative.transpose())) / (length * speed * speed);
  ScaledContact<N> scaled;
  scaled.first_row = first.transpose() * relative;
  scaled.second_row = second.transpose() * relative;
  scaled.first_push = push * first;
  scaled.second_push = push * second;
  scaled.wall = contact.wall;
  const Eigen::Vector2d offset_m = contact::offset(contact.wall);
  scaled.offset = {offset_m.x() / length, offset_m.y() / length};
  scaled.clearance = contact.clearance_m / length;
  scaled.stiffness = contact.stiffness_n_per_m * length;
  scaled.damping = contact.damping_ns_per_m * length * speed;
  scaled.friction = contact.friction;
  scaled.slip_scale_m_per_s = length * speed;
  scaled.surface_speed_m_per_s = contact.surface_speed_m_per_s;
  return scaled;
}

template <int N>
void scale_structure(const scene::Scene& scene, const MassFactor& mass, ScaledSystem<N>& system) {
  const double speed = scene.speed_rad_per_s;
  system.stiffness = mass.solve(scene.structure.stiffness) / (speed * speed);
  system.damping = mass.solve(scene.structure.damping) / speed;
  system.stiffness_diagonal = system.stiffness.diagonal();
  system.damping_diagonal = system.damping.diagonal();
  system.diagonal = system.stiffness.isDiagonal(0) && system.damping.isDiagonal(0);
}

template <int N>
void scale_forcing(const scene::Scene& scene, const MassFactor& mass, ScaledSystem<N>& system) {
  const double unit = scene.length_scale_m * scene.speed_rad_per_s * scene.speed_rad_per_s;
  system.cosine = mass.solve(Eigen::VectorXd(scene.harmonic_n.real())) / unit;
  system.sine = -mass.solve(Eigen::VectorXd(scene.harmonic_n.imag())) / unit;
  system.constant = mass.solve(scene.constant_n) / unit;
  system.pulse = ScaledSystem<N>::Vector::Zero(scene.structure.coordinates());
  if (scene.pulse && scene.pulse->force_n != 0) {
    system.pulse = mass.solve(scene.pulse->direction) * (scene.pulse->force_n / unit);
    system.pulse_end_rad = scene.pulse->duration_s * scene.speed_rad_per_s;
    system.pulse_rate = std::numbers::pi / system.pulse_end_rad;
    system.pulse_elapsed_rad = scene.pulse->elapsed_s * scene.speed_rad_per_s;
  }
}

}  // namespace

template <int N>
ScaledSystem<N> scale(const scene::Scene& scene) {
  if (N != Eigen::Dynamic && scene.structure.coordinates() != N)
    throw SolverError("scale: wrong coordinate count");
  const MassFactor mass(scene.structure.mass);
  ScaledSystem<N> system;
  scale_structure(scene, mass, system);
  scale_forcing(scene, mass, system);
  system.observed = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  for (const scene::Contact& contact : scene.contacts) {
    system.contacts.push_back(scale_contact<N>(contact, scene, mass));
  }
  system.length_m = scene.length_scale_m;
  system.speed_rad_per_s = scene.speed_rad_per_s;
  return system;
}

std::vector<double> scaled_initial_state(const scene::Scene& scene) {
  std::vector<double> state;
  for (const double q : scene.displacement_m) state.push_back(q / scene.length_scale_m);
  for (const double v : scene.velocity_m_per_s) {
    state.push_back(v / (scene.length_scale_m * scene.speed_rad_per_s));
  }
  return state;
}

template ScaledSystem<2> scale<2>(const scene::Scene&);
template ScaledSystem<4> scale<4>(const scene::Scene&);
template ScaledSystem<6> scale<6>(const scene::Scene&);
template ScaledSystem<Eigen::Dynamic> scale<Eigen::Dynamic>(const scene::Scene&);

}  // namespace rubsweep::integrate::run
