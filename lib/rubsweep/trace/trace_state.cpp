#include "rubsweep/trace/trace_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubsweep/contact/force_law.hpp"
#include "rubsweep/contact/friction_law.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/integrate/run/state_scale.hpp"
#include "rubsweep/scene/quiet_motion.hpp"

namespace rubsweep::trace {
namespace {

const auto& point(const scene::Scene& scene, int index) {
  return scene.structure.points[static_cast<std::size_t>(index)].map;
}

}  // namespace

StateReader::StateReader(const scene::Scene& scene, const integrate::run::SolverOptions& options)
    : scene_(scene),
      smoothing_m_(options.contact == integrate::run::ContactHandling::smoothed ? options.smoothing_m : 0) {
  for (const scene::Contact& contact : scene.contacts) {
    relative_.push_back(scene::relative_map(scene.structure, contact));
  }
}

TraceState StateReader::read(std::span<const double> scaled) const {
  if (scaled.size() != size()) {
    throw SolverError(fmt::format("a state of this scene has {} numbers, got {}", size(), scaled.size()));
  }
  const integrate::run::StateScale scale = integrate::run::state_scale(scene_);
  const Eigen::VectorXd q_m = scale.displacement_m(scaled), rate_m_per_s = scale.velocity_m_per_s(scaled);
  const auto& observed = point(scene_, scene_.observed_point);
  TraceState state{
      .displacement_m = observed * q_m, .velocity_m_per_s = observed * rate_m_per_s, .stops = {}};
  if (scene_.twist) {
    const Eigen::Index c = scene_.twist->coordinate;
    state.twist_rad = q_m(c);
    state.torque_nm =
        scene_.structure.stiffness(c, c) * q_m(c) + scene_.structure.damping(c, c) * rate_m_per_s(c);
  }
  for (std::size_t i = 0; i < stops(); ++i) state.stops.push_back(read_stop(i, q_m, rate_m_per_s));
  return state;
}

/// What holds a contact that sticks is no function of the state.
bool StateReader::sticks(const scene::Contact& contact, double slip_m_per_s) const {
  constexpr double no_slip = 1e-9;
  const double unit = std::max(contact.surface_speed_m_per_s, scene_.length_scale_m * scene_.speed_rad_per_s);
  return contact::dry_coefficient(contact.friction) > 0 && std::abs(slip_m_per_s) <= no_slip * unit;
}

StopState StateReader::read_stop(std::size_t index, const Eigen::VectorXd& q_m,
                                 const Eigen::VectorXd& rate_m_per_s) const {
  const scene::Contact& contact = scene_.contacts[index];
  const Eigen::Vector2d distance_m = relative_[index] * q_m + contact::offset(contact.wall);
  const Eigen::Vector2d rate = relative_[index] * rate_m_per_s;
  const Eigen::Vector2d normal = contact::normal_at(contact.wall, distance_m);
  const Eigen::Vector2d tangent(-normal.y(), normal.x());
  const double penetration_m = normal.dot(distance_m) - contact.clearance_m;
  const double closing_speed = normal.dot(rate);
  const double surface = scene_.twist ? scene_.twist->contact_radius_m[index] *
                                            (scene_.speed_rad_per_s + rate_m_per_s(scene_.twist->coordinate))
                                      : contact.surface_speed_m_per_s;
  const double slip = tangent.dot(rate) + surface;

  const contact::NormalForce force =
      smoothing_m_ > 0 ? contact::smoothed_elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m,
                                                     penetration_m, closing_speed, smoothing_m_)
                       : contact::elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m,
                                            penetration_m, closing_speed);
  StopState stop;
  if (contact.casing_point) stop.casing_m = point(scene_, *contact.casing_point) * q_m;
  stop.gap_m = -penetration_m;
  stop.normal_force_n = force.total_n;
  stop.friction_force_n =
      sticks(contact, slip) ? 0 : contact::friction_coefficient(contact.friction, slip) * force.spring_n;
  return stop;
}

}  // namespace rubsweep::trace
