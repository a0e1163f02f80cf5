#pragma once

#include <array>
#include <string_view>

#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::contact {

/// The four pieces of the clamped ElastoGap law; the law is smooth on each. p is the penetration, v the
/// closing speed dp/dt, K the stiffness, d the damping.
enum class Mode : unsigned char {
  open,      ///< p <= 0: no force
  clamped,   ///< p > 0, d v >= K p: normal force 2 K p
  sprung,    ///< p > 0, |d v| < K p: normal force K p + d v
  released,  ///< p > 0, K p + d v <= 0: normal force 0, friction still mu K p
};
inline constexpr int mode_count = 4;

constexpr std::string_view to_string(Mode mode) { return enumerator_word(mode); }

/// Penetration and its first two rates, in one consistent set of units.
struct Kinematics {
  double penetration = 0;
  double closing_speed = 0;
  double closing_acceleration = 0;
};

/// Mode of a state, without knowledge of earlier states. At exactly p = 0 the contact is open.
constexpr Mode mode_of(double stiffness, double damping, double penetration, double closing_speed) {
  if (penetration <= 0) return Mode::open;
  const double spring = stiffness * penetration;
  const double damper = damping * closing_speed;
  if (damper >= spring) return Mode::clamped;
  return spring + damper <= 0 ? Mode::released : Mode::sprung;
}

/// The law inside one mode, which is linear: normal force = spring K p + damper d v, friction = mu times
/// `friction` K p.
struct LinearLaw {
  double spring = 0, damper = 0, friction = 0;
};

/// Laws of the modes. Every solver reads this table, so that a change of the law is made in one place. (A
/// local table would be built anew in every call.)
inline constexpr std::array<LinearLaw, mode_count> linear_laws{{{0, 0, 0}, {2, 0, 1}, {1, 1, 1}, {0, 0, 1}}};
constexpr LinearLaw law_of(Mode mode) { return linear_laws[static_cast<std::size_t>(mode)]; }

/// Law of one mode, continued smoothly beyond the region of the mode, so that a step may overshoot its end.
constexpr NormalForce force_in_mode(Mode mode, double stiffness, double damping, double penetration,
                                    double closing_speed) {
  if (mode == Mode::open) return {};
  const LinearLaw law = law_of(mode);
  const double spring = stiffness * penetration;
  return {law.friction * spring, law.spring * spring + law.damper * (damping * closing_speed)};
}

/// Derivatives of the normal force in a mode.
constexpr ForceSlopes slopes_in_mode(Mode mode, double stiffness, double damping) {
  const LinearLaw law = law_of(mode);
  return {law.friction * stiffness, law.spring * stiffness, law.damper * damping};
}

/// One way out of a mode. The guard is spring K p + damper d v, or spring p if it does not depend on the
/// damper. It is negative inside the mode. When it rises through zero, the mode `next` follows.
struct GuardForm {
  double spring = 0, damper = 0;
  Mode next = Mode::open;
};

struct GuardForms {
  std::array<GuardForm, 2> list{};
  int count = 0;
};

/// The guards armed in `mode`, at most two:
/// open: p; clamped: K p - d v; sprung: d v - K p and -(K p + d v); released: -p and K p + d v.
/// Without damping, sprung is the only touching mode, and it ends as p falls through zero. These formulas are
/// stated only here.
constexpr GuardForms guard_forms(Mode mode, bool damped) {
  switch (mode) {
    case Mode::open: return {{{{1, 0, damped ? Mode::clamped : Mode::sprung}, {}}}, 1};
    case Mode::clamped: return {{{{1, -1, Mode::sprung}, {}}}, 1};
    case Mode::sprung:
      if (!damped) return {{{{-1, 0, Mode::open}, {}}}, 1};
      return {{{{-1, 1, Mode::clamped}, {-1, -1, Mode::released}}}, 2};
    case Mode::released: return {{{{-1, 0, Mode::open}, {1, 1, Mode::sprung}}}, 2};
  }
  return {};
}

/// Value and time derivative of a guard or event function at one state.
struct Guard {
  double value = 0;
  double rate = 0;
  Mode next = Mode::open;
};

struct Guards {
  std::array<Guard, 2> list{};
  int count = 0;
};

/// Values and rates, at a state, of the guards armed in `mode`.
constexpr Guards guards_of(Mode mode, double stiffness, double damping, const Kinematics& k) {
  const GuardForms forms = guard_forms(mode, damping > 0);
  Guards guards{{}, forms.count};
  for (std::size_t i = 0; i < static_cast<std::size_t>(forms.count); ++i) {
    const auto [spring, damper, next] = forms.list[i];
    if (damper == 0) {
      guards.list[i] = {spring * k.penetration, spring * k.closing_speed, next};
    } else {
      guards.list[i] = {spring * (stiffness * k.penetration) + damper * (damping * k.closing_speed),
                        spring * (stiffness * k.closing_speed) + damper * (damping * k.closing_acceleration),
                        next};
    }
  }
  return guards;
}

/// Mode to which a guard from `mode` towards `next` really leads. A sprung contact becomes clamped (at d v =
/// K p) while its penetration rises, and released (at d v = -K p) while it falls. With little damping both
/// guards are within rounding of p = 0, and chance decides which of the two a solver finds first. The sign of
/// v therefore decides.
constexpr Mode mode_through(Mode mode, Mode next, const Kinematics& kinematics) {
  if (mode != Mode::sprung || next == Mode::open) return next;
  return kinematics.closing_speed > 0 ? Mode::clamped : Mode::released;
}

/// Mode just after an instant at which `mode` may have ended: follows every guard that is at or past zero and
/// still rising, until there is none. A guard past zero but falling is a return from a graze, not an event.
/// Four steps are enough, because they visit every mode, and because not all guards can be at zero and rising
/// at once. `guards_in(mode)` returns the guards armed in a mode.
template <class GuardsIn>
constexpr Mode mode_after(Mode mode, const Kinematics& kinematics, const GuardsIn& guards_in) {
  for (int hop = 0; hop < mode_count; ++hop) {
    const Guards guards = guards_in(mode);
    Mode next = mode;
    for (int i = 0; i < guards.count; ++i) {
      const Guard& guard = guards.list[static_cast<std::size_t>(i)];
      if (guard.value >= 0 && guard.rate > 0) {
        next = mode_through(mode, guard.next, kinematics);
        break;
      }
    }
    if (next == mode) return mode;
    mode = next;
  }
  return mode;
}

constexpr Mode mode_after(Mode mode, double stiffness, double damping, const Kinematics& kinematics) {
  return mode_after(mode, kinematics, [&](Mode of) { return guards_of(of, stiffness, damping, kinematics); });
}

}  // namespace rubsweep::contact
