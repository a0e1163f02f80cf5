#include "rubsweep/analysis/trace/trace_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::trace {
namespace {

using Law = integrate::law::Dynamics<Eigen::Dynamic, false>;
using State = std::vector<double>;

/// Largest relative slip of a contact that sticks. Rounding lets this slip grow with the number of steps
/// since sticking began. It may exceed the tolerance by which a run locates the end of a slip.
constexpr double sticking_slip = 1e-9;

bool stands(const Law& law, std::size_t i, const State& state) {
  const auto& c = law.system().contacts[i];
  const double surface = c.surface_speed_m_per_s / c.slip_scale_m_per_s;
  return std::abs(law.slip(i, state)) <= sticking_slip * std::max(1.0, std::abs(surface));
}

/// Sets mode and direction of slip of every contact from the state alone, without history.
void enter(Law& law, const State& state) {
  for (std::size_t i = 0; i < law.modes().size(); ++i) {
    const auto& c = law.system().contacts[i];
    // if open, an annular stop's gap would be a difference of squares, with more rounding
    law.modes()[i] = contact::Mode::sprung;
    const contact::Kinematics k = law.kinematics(i, state, state);
    law.modes()[i] = contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    law.slips()[i] = law.slip(i, state) >= 0 ? contact::Slip::forward : contact::Slip::backward;
  }
}

/// Sum of the external forces on the structure. The forces of its own matrices and of contacts are not
/// included.
Eigen::VectorXd forcing_n(const scene::Scene& scene, double turns) {
  const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * (turns - std::floor(turns)));
  Eigen::VectorXd force = scene.constant_n + (scene.harmonic_n * turn).real();
  if (scene.second_harmonic_n.size() > 0) force += (scene.second_harmonic_n * (turn * turn)).real();
  for (const scene::Pulse& pulse : scene.pulses) {
    const double since_s = turns * scene.period_s() + pulse.elapsed_s;
    if (since_s >= 0 && since_s < pulse.duration_s)
      force += pulse.direction * (pulse.force_n * std::sin(std::numbers::pi * since_s / pulse.duration_s));
  }
  return force;
}

const auto& point(const scene::Scene& scene, int index) {
  return scene.structure.points[static_cast<std::size_t>(index)].map;
}

}  // namespace

DryForces::DryForces(const scene::Scene& scene)
    : any_(std::ranges::any_of(scene.contacts, [](const scene::Contact& contact) {
        return contact::holding_coefficient(contact.friction) > 0;
      })) {
  if (any_) system_ = integrate::run::scale<Eigen::Dynamic>(scene);
}

std::vector<double> DryForces::forces_n(const scene::Scene& scene, std::span<const double> scaled,
                                        double turns) const {
  std::vector<double> forces(scene.contacts.size());
  if (!any_) return forces;
  const State state(scaled.begin(), scaled.end());
  State rate(state.size());
  const double whole = std::floor(turns), phase = 2 * std::numbers::pi * (turns - whole);
  integrate::run::PulseTimes pulses(scene, system_.scale, 2 * std::numbers::pi);
  pulses.begin_turn(static_cast<long>(whole));
  pulses.go_to(phase);
  Law law(system_, 0);
  law.follow(pulses);
  enter(law, state);
  integrate::law::settle_slips(law, state, rate, phase, [&](std::size_t i) { return stands(law, i, state); });
  law.loose(state, rate, phase);
  const Law::Holding holding = law.hold(state, rate);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!law.touches_dry(i)) continue;
    forces[i] = law.slips()[i] == contact::Slip::sticking ? holding.force_n(i) : law.friction_n(i, state);
  }
  return forces;
}

Energy structure_energy(const scene::Scene& scene, const Eigen::VectorXd& q_m,
                        const Eigen::VectorXd& rate_m_per_s, double turns) {
  const structure::LinearSystem& system = scene.structure;
  const Eigen::VectorXd spring = system.stiffness * q_m, back = system.stiffness.transpose() * q_m;
  Energy energy;
  energy.kinetic_j = rate_m_per_s.dot(system.mass * rate_m_per_s) / 2;
  energy.elastic_j = q_m.dot(spring) / 2;
  energy.damping_w = -rate_m_per_s.dot(system.damping * rate_m_per_s) - rate_m_per_s.dot(spring - back) / 2;
  energy.forcing_w =
      scene.twist ? std::numeric_limits<double>::quiet_NaN() : rate_m_per_s.dot(forcing_n(scene, turns));
  return energy;
}

double spring_energy_j(double stiffness_n_per_m, double penetration_m, double smoothing_m) {
  const double p = penetration_m, half = smoothing_m / 2;
  if (p <= -half) return 0;
  if (p >= half) return stiffness_n_per_m * (p * p / 2 + smoothing_m * smoothing_m / 24);
  return stiffness_n_per_m * (p + half) * (p + half) * (p + half) / (6 * smoothing_m);
}

StateReader::StateReader(const scene::Scene& scene, const integrate::run::SolverOptions& options)
    : scene_(scene),
      smoothing_m_(options.contact == integrate::run::ContactHandling::smoothed ? options.smoothing_m : 0),
      dry_forces_(scene) {
  for (const scene::Contact& contact : scene.contacts) {
    relative_.push_back(scene::relative_map(scene.structure, contact));
  }
  impact_damping_.resize(stops());
  if (std::ranges::none_of(scene.contacts, [](const scene::Contact& c) { return c.law != nullptr; })) return;
  const auto system = integrate::run::scale<Eigen::Dynamic>(scene);
  Law law(system, 0);
  const State state = integrate::run::scaled_initial_state(scene);
  for (std::size_t i = 0; i < stops(); ++i) {
    law.enter_by_state(i, state, state);
    impact_damping_[i] = law.impact_damping(i);
  }
}

void StateReader::pass(const integrate::run::ModeSwitch& change) {
  const auto i = static_cast<std::size_t>(change.contact);
  if (change.from == contact::Mode::open && i < impact_damping_.size())
    impact_damping_[i] = change.impact_damping;
}

contact::NormalForce StateReader::normal_force(std::size_t index, const StopMotion& motion) const {
  const scene::Contact& contact = scene_.contacts[index];
  const double p_m = motion.penetration_m, v_m_per_s = motion.closing_speed_m_per_s;
  if (contact.law) {
    if (p_m <= 0) return {};
    const double spring_n = contact.law->force_n(p_m);
    const double v = v_m_per_s / integrate::run::state_scale(scene_).unit_velocity_m_per_s();
    return {spring_n, spring_n * std::max(0.0, 1 + impact_damping_[index] * v)};
  }
  return smoothing_m_ > 0
             ? contact::smoothed_elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m, p_m,
                                           v_m_per_s, smoothing_m_)
             : contact::elastogap(contact.stiffness_n_per_m, contact.damping_ns_per_m, p_m, v_m_per_s);
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

/// Friction force. A smoothed law lets dry friction follow tanh(slip / (smoothing width x shaft speed)).
double StateReader::friction_n(const scene::Contact& contact, double slip_m_per_s, double spring_n,
                               double dry_n) const {
  const contact::FrictionTerms terms = contact::friction_terms(contact.friction);
  if (terms.holding == 0) return contact::friction_coefficient(contact.friction, slip_m_per_s) * spring_n;
  if (smoothing_m_ == 0) return dry_n;
  return terms.dry * std::tanh(slip_m_per_s / (scene_.speed_rad_per_s * smoothing_m_)) * spring_n;
}

void StateReader::add_forces(std::size_t index, double dry_n, TraceState& state) const {
  const scene::Contact& contact = scene_.contacts[index];
  const StopMotion motion = stop_motion(index, state);
  const double surface = scene_.twist
                             ? scene_.twist->contact_radius_m[index] *
                                   (scene_.speed_rad_per_s + state.rates_m_per_s(scene_.twist->coordinate))
                             : contact.surface_speed_m_per_s;
  const contact::NormalForce force = normal_force(index, motion);
  StopState& stop = state.stops[index];
  stop.normal_force_n = force.total_n;
  stop.friction_force_n = friction_n(contact, motion.sliding_speed_m_per_s + surface, force.spring_n, dry_n);
  state.energy.contact_j +=
      contact.law ? contact.law->energy_j(std::max(0.0, motion.penetration_m))
                  : spring_energy_j(contact.stiffness_n_per_m, motion.penetration_m, smoothing_m_);
  state.energy.contact_damping_w -= (force.total_n - force.spring_n) * motion.closing_speed_m_per_s;
  state.energy.friction_w -= stop.friction_force_n * motion.sliding_speed_m_per_s;
}

}  // namespace rubsweep::trace
