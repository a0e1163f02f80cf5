#include "rubsweep/trace/trace_state.hpp"

#include <fmt/format.h>

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
      smoothing_m_(options.contact == integrate::run::ContactHandling::smoothed ? options.smoothing_m : 0),
      dry_forces_(scene) {
  for (const scene::Contact& contact : scene.contacts) {
    relative_.push_back(scene::relative_map(scene.structure, contact));
  }
}

TraceState StateReader::read_motion(std::span<const double> scaled) const {
  if (scaled.size() != size()) {
    throw SolverError(fmt::format("a state of this scene has {} numbers, got {}", size(), scaled.size()));
  }
  const integrate::run::StateScale scale = integrate::run::state_scale(scene_);
  TraceState state;
  state.coordinates_m = scale.displacement_m(scaled);
  state.rates_m_per_s = scale.velocity_m_per_s(scaled);
  const Eigen::VectorXd &q_m = state.coordinates_m, &rate_m_per_s = state.rates_m_per_s;
  const auto& observed = point(scene_, scene_.observed_point);
  state.displacement_m = observed * q_m;
  state.velocity_m_per_s = observed * rate_m_per_s;
  if (scene_.twist) {
    const Eigen::Index c = scene_.twist->coordinate;
    state.twist_rad = q_m(c);
    state.torque_nm =
        scene_.structure.stiffness(c, c) * q_m(c) + scene_.structure.damping(c, c) * rate_m_per_s(c);
  }
  state.stops.resize(stops());
  for (std::size_t i = 0; i < stops(); ++i) {
    StopState& stop = state.stops[i];
    stop.gap_m = -stop_motion(i, state).penetration_m;
    if (!scene_.contacts[i].casing_point) continue;
    const auto& casing = point(scene_, *scene_.contacts[i].casing_point);
    stop.casing_m = casing * q_m;
    stop.casing_m_per_s = casing * rate_m_per_s;
  }
  return state;
}

TraceState StateReader::read(std::span<const double> scaled, double turns) const {
  TraceState state = read_motion(scaled);
  state.energy = structure_energy(scene_, state.coordinates_m, state.rates_m_per_s, turns);
  std::vector<double> dry_n(stops());
  if (dry_forces_.any() && smoothing_m_ == 0) dry_n = dry_forces_.forces_n(scene_, scaled, turns);
  for (std::size_t i = 0; i < stops(); ++i) add_forces(i, dry_n[i], state);
  return state;
}

StateReader::StopMotion StateReader::stop_motion(std::size_t index, const TraceState& state) const {
  const scene::Contact& contact = scene_.contacts[index];
  const Eigen::Vector2d distance_m = relative_[index] * state.coordinates_m + contact::offset(contact.wall);
  const Eigen::Vector2d rate = relative_[index] * state.rates_m_per_s;
  const Eigen::Vector2d normal = contact::normal_at(contact.wall, distance_m);
  const Eigen::Vector2d tangent(-normal.y(), normal.x());
  return {normal.dot(distance_m) - contact.clearance_m, normal.dot(rate), tangent.dot(rate)};
}

/// A smoothed law takes dry friction over from one way to the other within one smoothing width a radian.
double StateReader::friction_n(const scene::Contact& contact, double slip_m_per_s, double spring_n,
                               double dry_n) const {
  const double dry = contact::dry_coefficient(contact.friction);
  if (dry == 0) return contact::friction_coefficient(contact.friction, slip_m_per_s) * spring_n;
  if (smoothing_m_ == 0) return dry_n;
  return dry * std::tanh(slip_m_per_s / (scene_.speed_rad_per_s * smoothing_m_)) * spring_n;
}

void StateReader::add_forces(std::size_t index, double dry_n, TraceState& state) const {
  const scene::Contact& contact = scene_.contacts[index];
  const StopMotion motion = stop_motion(index, state);
  const double surface = scene_.twist
                             ? scene_.twist->contact_radius_m[index] *
                                   (scene_.speed_rad_per_s + state.rates_m_per_s(scene_.twist->coordinate))
                             : contact.surface_speed_m_per_s;
  const contact::NormalForce force =
      smoothing_m_ > 0
          ? contact::smoothed_elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m,
                                        motion.penetration_m, motion.closing_speed_m_per_s, smoothing_m_)
          : contact::elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m, motion.penetration_m,
                               motion.closing_speed_m_per_s);
  StopState& stop = state.stops[index];
  stop.normal_force_n = force.total_n;
  stop.friction_force_n = friction_n(contact, motion.sliding_speed_m_per_s + surface, force.spring_n, dry_n);
  state.energy.contact_j += spring_energy_j(contact.stiffness_n_per_m, motion.penetration_m, smoothing_m_);
  state.energy.contact_damping_w -= (force.total_n - force.spring_n) * motion.closing_speed_m_per_s;
  state.energy.friction_w -= stop.friction_force_n * motion.sliding_speed_m_per_s;
}

}  // namespace rubsweep::trace
