#pragma once

#include <array>
#include <string_view>

#include "rubsweep/contact/force_law.hpp"

namespace rubsweep::contact {

/// The four pieces on each of which the clamped ElastoGap law is smooth. p is the penetration, v the closing
/// speed dp/dt, K the stiffness, d the damping.
enum class Mode : unsigned char {
  open,      ///< p <= 0: no force
  clamped,   ///< p > 0, d v >= K p: normal force 2 K p
  sprung,    ///< p > 0, |d v| < K p: normal force K p + d v
  released,  ///< p > 0, K p + d v <= 0: normal force 0, friction still mu K p
};
inline constexpr int mode_count = 4;

constexpr std::string_view to_string(Mode mode) {
  constexpr std::array<std::string_view, mode_count> names{"open", "clamped", "sprung", "released"};
  return names[static_cast<std::size_t>(mode)];
}

/// Penetration and its first two rates, in one consistent set of units.
struct Kinematics {
  double penetration = 0;
  double closing_speed = 0;
  double closing_acceleration = 0;
};

/// Mode of a state, without knowledge of the past. At p = 0 exactly the contact is open.
constexpr Mode mode_of(double stiffness, double damping, double penetration, double closing_speed) {
  if (penetration <= 0) return Mode::open;
  const double spring = stiffness * penetration;
  const double damper = damping * closing_speed;
  if (damper >= spring) return Mode::clamped;
  return spring + damper <= 0 ? Mode::released : Mode::sprung;
}

/// Law of one mode, continued smoothly beyond the mode's own region so that a step may overshoot its end.
constexpr NormalForce force_in_mode(Mode mode, double stiffness, double damping, double penetration,
                                    double closing_speed) {
  const double spring = stiffness * penetration;
  switch (mode) {
    case Mode::open:
      return {0, 0};
    case Mode::clamped:
      return {spring, 2 * spring};
    case Mode::sprung:
      return {spring, spring + damping * closing_speed};
    case Mode::released:
      return {spring, 0};
  }
  return {};
}

/// One way out of a mode, a guard or event function: `value` is negative inside the mode, which ends when it
/// rises through zero. `rate` is its time derivative.
struct Guard {
  double value = 0;
  double rate = 0;
  Mode next = Mode::open;
};

struct Guards {
  std::array<Guard, 2> list{};
  int count = 0;
};

/// The guards armed in `mode`, at most two:
/// open: p; clamped: K p - d v; sprung: d v - K p and -(K p + d v); released: -p and K p + d v.
/// Without damping sprung is the only touching mode and ends as p falls through zero.
constexpr Guards guards_of(Mode mode, double stiffness, double damping, const Kinematics& k) {
  const double spring = stiffness * k.penetration;
  const double spring_rate = stiffness * k.closing_speed;
  const double damper = damping * k.closing_speed;
  const double damper_rate = damping * k.closing_acceleration;
  switch (mode) {
    case Mode::open: {
      const Mode touching = damping > 0 ? Mode::clamped : Mode::sprung;
      return {{{{k.penetration, k.closing_speed, touching}, {}}}, 1};
    }
    case Mode::clamped:
      return {{{{spring - damper, spring_rate - damper_rate, Mode::sprung}, {}}}, 1};
    case Mode::sprung:
      if (damping == 0) return {{{{-k.penetration, -k.closing_speed, Mode::open}, {}}}, 1};
      return {{{{damper - spring, damper_rate - spring_rate, Mode::clamped},
                {-spring - damper, -spring_rate - damper_rate, Mode::released}}},
              2};
    case Mode::released:
      return {{{{-k.penetration, -k.closing_speed, Mode::open},
                {spring + damper, spring_rate + damper_rate, Mode::sprung}}},
              2};
  }
  return {};
}

/// Where a guard from `mode` towards `next` really leads. A sprung contact becomes clamped (at d v = K p)
/// while its penetration rises, and released (at d v = -K p) while it falls. With little damping both happen
/// within rounding of p = 0, and which of the two a solver meets first there is chance: the sign of v
/// decides.
constexpr Mode mode_through(Mode mode, Mode next, const Kinematics& kinematics) {
  if (mode != Mode::sprung || next == Mode::open) return next;
  return kinematics.closing_speed > 0 ? Mode::clamped : Mode::released;
}

/// Mode just after an instant at which `mode` may have ended: follows every guard that is at or past zero and
/// still rising, until none is. A guard past zero but falling is a return from a graze, not an event.
/// Bounded: a state with all guards at zero and rising cannot exist, and four hops visit every mode.
constexpr Mode mode_after(Mode mode, double stiffness, double damping, const Kinematics& kinematics) {
  for (int hop = 0; hop < mode_count; ++hop) {
    const Guards guards = guards_of(mode, stiffness, damping, kinematics);
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

}  // namespace rubsweep::contact
