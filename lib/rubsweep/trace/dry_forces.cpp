#include "rubsweep/trace/dry_forces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/contact/friction_law.hpp"
#include "rubsweep/integrate/law/dynamics.hpp"
#include "rubsweep/integrate/law/settle_slips.hpp"
#include "rubsweep/integrate/run/pulse_times.hpp"

namespace rubsweep::trace {
namespace {

using Law = integrate::law::Dynamics<Eigen::Dynamic, false>;
using State = std::vector<double>;

/// A contact that sticks keeps a slip of rounding, which grows with the steps since it came to stick: more
/// than a run takes for zero when it looks for the instant at which a slip ends.
constexpr double sticking_slip = 1e-9;

bool stands(const Law& law, std::size_t i, const State& state) {
  const auto& c = law.system().contacts[i];
  const double surface = c.surface_speed_m_per_s / c.slip_scale_m_per_s;
  return std::abs(law.slip(i, state)) <= sticking_slip * std::max(1.0, std::abs(surface));
}

/// Initialises the mode of every contact from the state, ignoring history, and the directions of their slips.
void enter(Law& law, const State& state) {
  for (std::size_t i = 0; i < law.modes().size(); ++i) {
    const auto& c = law.system().contacts[i];
    law.modes()[i] = contact::Mode::sprung;  // an open annular stop measures by squares
    const contact::Kinematics k = law.kinematics(i, state, state);
    law.modes()[i] = contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    law.slips()[i] = law.slip(i, state) >= 0 ? contact::Slip::forward : contact::Slip::backward;
  }
}

}  // namespace

DryForces::DryForces(const scene::Scene& scene)
    : any_(std::ranges::any_of(scene.contacts, [](const scene::Contact& contact) {
        return contact::dry_coefficient(contact.friction) > 0;
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

}  // namespace rubsweep::trace
