#include "rubsweep/analysis/branch/orbits/guard_motion.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::branch::orbits {
namespace {

/// Step of the shaft's rotation for the guard's second derivative: the error of the central difference and
/// its rounding both stay near 1e-10.
constexpr double difference_step_rad = 1e-5;

}  // namespace

SectionGuards::SectionGuards(const scene::Scene& scene)
    : system_(integrate::run::scale<Eigen::Dynamic>(scene)), dynamics_(system_, 0) {}

std::optional<GuardMotion> SectionGuards::at(std::span<const double> section, const ArmedGuard& guard) {
  const State state(section.begin(), section.end());
  enter_modes(state, guard);
  const auto here = guard_at(state, 0, guard);
  if (!here) return std::nullopt;
  State rate(state.size());
  dynamics_(state, rate, 0);
  State before = state, behind = state;
  for (std::size_t i = 0; i < state.size(); ++i) {
    before[i] -= difference_step_rad * rate[i];
    behind[i] += difference_step_rad * rate[i];
  }
  const auto earlier = guard_at(before, -difference_step_rad, guard),
             later = guard_at(behind, difference_step_rad, guard);
  return GuardMotion{here->value, here->rate, (later->rate - earlier->rate) / (2 * difference_step_rad)};
}

/// In units of length: a guard of forces is divided by the stiffness.
std::optional<contact::Guard> SectionGuards::guard_at(const State& state, double phase_rad,
                                                      const ArmedGuard& guard) const {
  const auto i = static_cast<std::size_t>(guard.contact);
  const auto& contact = system_.contacts[i];
  State rate(state.size());
  dynamics_(state, rate, phase_rad);
  const contact::Guards guards = contact::guards_of(guard.from, contact.stiffness, contact.damping,
                                                    dynamics_.kinematics(i, state, rate));
  const contact::GuardForms forms = contact::guard_forms(guard.from, contact.damping > 0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(guards.count); ++k) {
    contact::Guard found = guards.list[k];
    if (found.next != guard.to) continue;
    if (forms.list[k].damper != 0) {
      found.value /= contact.stiffness;
      found.rate /= contact.stiffness;
    }
    return found;
  }
  return std::nullopt;
}

void SectionGuards::enter_modes(const State& state, const ArmedGuard& guard) {
  auto& modes = dynamics_.modes();
  modes.assign(modes.size(), contact::Mode::open);
  State rate(state.size());
  dynamics_(state, rate, 0);
  for (std::size_t i = 0; i < modes.size(); ++i) dynamics_.enter_by_state(i, state, rate);
  modes[static_cast<std::size_t>(guard.contact)] = guard.from;
}

scene::Scene begun_at_phase(scene::Scene scene, double phase_rad) {
  scene.harmonic_n *= std::polar(1.0, phase_rad);
  scene.second_harmonic_n *= std::polar(1.0, 2 * phase_rad);
  for (structure::ImpulseTrain& train : scene.impulses) {
    const double periods = train.phase_periods - train.multiple * phase_rad / (2 * std::numbers::pi);
    const double rest = periods - std::floor(periods);
    train.phase_periods = rest < 1 ? rest : 0;
  }
  return scene;
}

}  // namespace rubsweep::branch::orbits
