#include "rubsweep/core/integrate/run/scaled_system.hpp"

#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/run/second_harmonic.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::integrate::run {
namespace {

using MassFactor = numerics::dense::SymmetricFactors;

template <int N>
ScaledContact<N> scale_contact(const scene::Contact& contact, const scene::Scene& scene,
                               const StateScale& scale, const MassFactor& mass) {
  const auto relative = scene::relative_map(scene.structure, contact);
  const Eigen::Vector2d first = contact::first_direction(contact.wall);
  const Eigen::Vector2d second(-first.y(), first.x());
  // A force f on the casing acts on the coordinates as -relative^T f.
  const Eigen::MatrixXd push =
      -mass.solve(Eigen::MatrixXd(relative.transpose())) / scale.unit_acceleration_m_per_s2();
  ScaledContact<N> scaled;
  scaled.first_row = first.transpose() * relative;
  scaled.second_row = second.transpose() * relative;
  scaled.first_push = push * first;
  scaled.second_push = push * second;
  scaled.wall = contact::in_units(contact.wall, scale.length_m);
  const Eigen::Vector2d offset = contact::offset(scaled.wall);
  scaled.offset = {offset.x(), offset.y()};
  scaled.clearance = contact.clearance_m / scale.length_m;
  scaled.stiffness = scale.stiffness_n(contact.stiffness_n_per_m);
  scaled.damping = scale.damping_n(contact.damping_ns_per_m);
  scaled.friction = contact.friction;
  scaled.slip_scale_m_per_s = scale.unit_velocity_m_per_s();
  scaled.surface_speed_m_per_s = contact.surface_speed_m_per_s;
  scaled.law = contact.law;
  scaled.length_m = scale.length_m;
  return scaled;
}

/// `system` must already have its structure and its constant forces.
template <int N>
ScaledCasing<N> scale_casing(std::size_t contact, const structure::Point& point,
                             const ScaledSystem<N>& system) {
  ScaledCasing<N> casing;
  casing.contact = contact;
  casing.map = point.map;
  // Both coordinates of a casing have equal coefficients and are uncoupled.
  casing.rate = std::sqrt(casing.map.row(0).dot(casing.map.row(0) * system.stiffness));
  casing.sag = casing.map * system.constant / (casing.rate * casing.rate);
  return casing;
}

template <int N>
void scale_structure(const scene::Scene& scene, const MassFactor& mass, ScaledSystem<N>& system) {
  const double speed = system.scale.speed_rad_per_s;
  system.stiffness = mass.solve(scene.structure.stiffness) / (speed * speed);
  system.damping = mass.solve(scene.structure.damping) / speed;
  system.stiffness_diagonal = system.stiffness.diagonal();
  system.damping_diagonal = system.damping.diagonal();
  system.diagonal = system.stiffness.isDiagonal(0) && system.damping.isDiagonal(0);
}

template <int N>
void scale_forcing(const scene::Scene& scene, const MassFactor& mass, ScaledSystem<N>& system) {
  const double unit = system.scale.unit_acceleration_m_per_s2();
  system.cosine = mass.solve(Eigen::VectorXd(scene.harmonic_n.real())) / unit;
  system.sine = -mass.solve(Eigen::VectorXd(scene.harmonic_n.imag())) / unit;
  system.constant = mass.solve(scene.constant_n) / unit;
  for (const scene::Pulse& pulse : scene.pulses) {
    system.pulses.push_back({.top = mass.solve(pulse.direction) * (pulse.force_n / unit),
                             .rate = std::numbers::pi / system.scale.duration(pulse.duration_s)});
  }
  const double period = system.scale.duration(scene.period_s());
  for (const HarmonicPart& part : second_harmonic(scene)) {
    system.pulses.push_back({.top = mass.solve(part.top_n) / unit,
                             .rate = 4 * std::numbers::pi / period,
                             .always_elapsed = period * part.turns_ahead});
  }
}

}  // namespace

template <int N>
ScaledSystem<N> scale(const scene::Scene& scene, const StateScale& scale) {
  if (N != Eigen::Dynamic && scene.structure.coordinates() != N)
    throw SolverError("scale: wrong coordinate count");
  const MassFactor mass(scene.structure.mass);
  ScaledSystem<N> system;
  system.scale = scale;
  scale_structure(scene, mass, system);
  scale_forcing(scene, mass, system);
  system.observed = scene::observed(scene);
  for (const scene::Contact& contact : scene.contacts) {
    if (contact.casing_point) {
      const auto& point = scene.structure.points[static_cast<std::size_t>(*contact.casing_point)];
      system.casings.push_back(scale_casing<N>(system.contacts.size(), point, system));
    }
    system.contacts.push_back(scale_contact<N>(contact, scene, scale, mass));
  }
  return system;
}

template ScaledSystem<2> scale<2>(const scene::Scene&, const StateScale&);
template ScaledSystem<4> scale<4>(const scene::Scene&, const StateScale&);
template ScaledSystem<6> scale<6>(const scene::Scene&, const StateScale&);
template ScaledSystem<Eigen::Dynamic> scale<Eigen::Dynamic>(const scene::Scene&, const StateScale&);

}  // namespace rubsweep::integrate::run
