#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/integrate/law/contact_states.hpp"
#include "rubsweep/core/integrate/law/curved_contacts.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"

namespace rubsweep::integrate::law {

/// Normal force and friction of each contact of a system at one state, the mode after it, and the guards of
/// its modes. A located contact obeys the law of its current mode, continued smoothly past the mode's end. A
/// smoothed contact obeys the blended linear law and has no modes. Dry friction, which jumps where the slip
/// reverses, depends on `slips`.
template <int N, bool Smoothed>
class ContactForces : public ContactStates<N, Smoothed> {
  using States = ContactStates<N, Smoothed>;

 public:
  using typename States::ConstMap;

  ContactForces(const run::ScaledSystem<N>& system, double smoothing_width)
      : States(system), smoothing_width_(smoothing_width), curved_(system) {}

  /// Largest friction in newtons of contact `i`, which must be touching.
  template <class State>
  double largest_friction_n(std::size_t i, const State& state) const {
    const contact::ContactFrame f = this->frame_at(i, state);
    return dry_[i].holding * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }
  /// Friction in newtons with which contact `i` begins to slip.
  template <class State>
  double sliding_friction_n(std::size_t i, const State& state) const {
    const contact::ContactFrame f = this->frame_at(i, state);
    const double coefficient = dry_[i].jumps() ? dry_[i].dry : dry_[i].holding;
    return coefficient * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }

  /// Penetration of contact `i` and its two rates, scaled, from a state and its rate; as by
  /// contact::open_kinematics while the contact is open.
  template <class State>
  contact::Kinematics kinematics(std::size_t i, const State& state, const State& rate) const {
    const Eigen::Index n = system_.coordinates();
    const auto& c = system_.contacts[i];
    const ConstMap acceleration(&rate[0] + n, n);
    const contact::RelativeMotion m = relative_motion(c, ConstMap(&state[0], n), ConstMap(&state[0] + n, n));
    const double a1 = c.first_row.dot(acceleration.transpose());
    const double a2 = c.second_row.dot(acceleration.transpose());
    return !Smoothed && modes_[i] == contact::Mode::open
               ? contact::open_kinematics(c.wall, m, a1, a2, c.clearance)
               : contact::kinematics(c.wall, m, a1, a2, c.clearance);
  }

  /// Puts contact `i` into the mode that belongs to a state; `rate` was computed with the modes before. A
  /// contact exactly at the wall that moves into it is in contact from the first instant.
  template <class State>
  void enter_by_state(std::size_t i, const State& state, const State& rate) {
    const Contact& c = system_.contacts[i];
    const bool begins = modes_[i] == contact::Mode::open;
    contact::Kinematics k = kinematics(i, state, rate);
    if (k.penetration > 0) {
      // The guard of an open annular stop is a difference of squares, but the penetration itself separates
      // the modes.
      modes_[i] = contact::Mode::sprung;
      k = kinematics(i, state, rate);
    }
    if (begins) curved_.begin_inside(i, k);
    const contact::Mode mode = c.law
                                   ? contact::curved_mode(impact_damping(i), k.penetration, k.closing_speed)
                                   : contact::mode_of(c.stiffness, c.damping, k.penetration, k.closing_speed);
    modes_[i] = mode_after(i, mode, k);
  }

  /// Guards armed in the mode of contact `i`. The second function gives the mode just after an instant at
  /// which `mode` may have ended.
  contact::Guards guards(std::size_t i, const contact::Kinematics& k) const {
    return guards(i, modes_[i], k);
  }
  contact::Mode mode_after(std::size_t i, contact::Mode mode, const contact::Kinematics& k) const {
    return contact::mode_after(mode, k, [&](contact::Mode of) { return guards(i, of, k); });
  }

  /// Begins an impact at contact `i` with this closing speed, on which the damping may depend.
  void begin_impact(std::size_t i, double closing_speed) { curved_.begin_impact(i, closing_speed); }
  double impact_damping(std::size_t i) const { return curved_.impact_damping(i); }

  /// Normal force in newtons by the law in use.
  contact::NormalForce normal_force(std::size_t i, double penetration, double closing_speed) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      return contact::smoothed_elastogap(c.stiffness, c.damping, penetration, closing_speed,
                                         smoothing_width_);
    } else {
      if (c.law) [[unlikely]]
        return curved_.force(i, modes_[i], penetration, closing_speed);
      return contact::force_in_mode(modes_[i], c.stiffness, c.damping, penetration, closing_speed);
    }
  }

  template <class State>
  double slip_m_per_s(std::size_t i, const State& state) const {
    return law::slip_m_per_s(system_.contacts[i], this->frame_at(i, state));
  }

  /// Friction force of contact `i` on the casing, in newtons along the tangent.
  template <class State>
  double friction_n(std::size_t i, const State& state) const {
    if (!Smoothed && modes_[i] == contact::Mode::open) return 0;
    const contact::ContactFrame f = this->frame_at(i, state);
    if (Smoothed && f.penetration <= -smoothing_width_ / 2) return 0;
    return coefficient(i, f) * normal_force(i, f.penetration, f.closing_speed).spring_n;
  }

  /// Rate at which friction alone changes the slip at contact `i`, divided by the angular frequency of the
  /// contact's spring between the masses it joins. Zero where friction does not depend on the slip, and in an
  /// open contact.
  template <class State>
  double friction_ratio(std::size_t i, const State& state) const {
    const Eigen::Index n = system_.coordinates();
    const ConstMap u(&state[0], n), v(&state[0] + n, n);
    const Contact& c = system_.contacts[i];
    if (!Smoothed && modes_[i] == contact::Mode::open) return 0;
    const contact::ContactFrame f = contact_frame(c, u, v);
    const double slope = coefficient_slope(i, f);
    if (slope <= 0) return 0;
    const double spring_n = normal_force(i, f.penetration, f.closing_speed).spring_n;
    return slope * spring_n * std::sqrt(c.mobility() / c.stiffness);
  }

  /// Largest friction ratio of all touching contacts.
  template <class State>
  double friction_ratio(const State& state) const {
    double largest = 0;
    for (std::size_t i = 0; i < system_.contacts.size(); ++i)
      largest = std::max(largest, friction_ratio(i, state));
    return largest;
  }

 protected:
  using States::dry_;
  using States::modes_;
  using States::slips_;
  using States::system_;
  using typename States::Contact;

  /// Friction over spring force, 0 for a sticking contact, and its derivative by the scaled slip. A smoothed
  /// law changes the direction of dry friction within one smoothing width per radian.
  double coefficient(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    const contact::FrictionTerms& dry = dry_[i];
    if (dry.holding == 0) return contact::friction_coefficient(c.friction, law::slip_m_per_s(c, f));
    if constexpr (Smoothed)
      return dry.dry * std::tanh(law::slip_m_per_s(c, f) / (c.slip_scale_m_per_s * smoothing_width_));
    const double way = contact::sign_of(slips_[i]);
    if (dry.holding == dry.dry) return dry.dry * way;
    if (this->poised(i)) return dry.holding * way;
    if (dry.falling.height == 0) return dry.dry * way;
    return way * (dry.dry + dry.falling.at(way * law::slip_m_per_s(c, f)));
  }
  double coefficient_slope(std::size_t i, const contact::ContactFrame& f) const {
    const Contact& c = system_.contacts[i];
    const contact::FrictionTerms& dry = dry_[i];
    if (dry.holding == 0)
      return contact::friction_slope(c.friction, law::slip_m_per_s(c, f)) * c.slip_scale_m_per_s;
    if constexpr (!Smoothed) {
      const double way = contact::sign_of(slips_[i]);
      if (way == 0 || dry.falling.height == 0 || this->poised(i)) return 0;
      return dry.falling.slope(way * law::slip_m_per_s(c, f)) * c.slip_scale_m_per_s;
    }
    const double share = std::tanh(law::slip_m_per_s(c, f) / (c.slip_scale_m_per_s * smoothing_width_));
    return dry.dry * (1 - share * share) / smoothing_width_;
  }

  contact::ForceSlopes force_slopes(std::size_t i, double p, double v) const {
    const auto& c = system_.contacts[i];
    if constexpr (Smoothed) {
      return contact::smoothed_elastogap_slopes(c.stiffness, c.damping, p, v, smoothing_width_);
    } else {
      if (!c.law) return contact::slopes_in_mode(modes_[i], c.stiffness, c.damping);
      return curved_.slopes(i, modes_[i], p, v);
    }
  }

  contact::Guards guards(std::size_t i, contact::Mode mode, const contact::Kinematics& k) const {
    const Contact& c = system_.contacts[i];
    return c.law ? contact::curved_guards(mode, impact_damping(i), k)
                 : contact::guards_of(mode, c.stiffness, c.damping, k);
  }

  double smoothing_width_;

 private:
  CurvedContacts<N> curved_;
};

}  // namespace rubsweep::integrate::law
