#pragma once

#include <array>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/taylor/contact_law.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

class Creep;

/// Motion and forces of one contact as power series of the time, within one contact mode. In its two fixed
/// directions the relative displacement is d = (d1, d2); around the rotor r = |d| and the normal is d / r.
class ContactSeries {
 public:
  /// Relative displacement, offset included, and coefficients of its rate in their order: coefficient k
  /// before `force_term(k)` is asked for.
  void set_distance(numerics::Twin distance) { distance_.set(0, distance); }
  void set_velocity(int k, numerics::Twin velocity) {
    velocity_.set(k, velocity);
    distance_.set(k + 1, velocity * numerics::one_over_twice(k + 1));
  }
  const numerics::PlaneSeries& distance() const { return distance_; }
  const numerics::PlaneSeries& velocity() const { return velocity_; }

  /// Starts an expansion in `mode` with the slip there, which decides what part of the friction is saturated.
  /// Dry friction depends on `way` instead, and is at its bound where it is `poised` (ContactStates).
  void begin(const ContactLaw& law, contact::Mode mode, double slip_m_per_s, contact::Slip way,
             bool poised = false);
  /// Makes the expansion that has begun keep the slip of `creep`, by a friction that the whole system
  /// decides: as a contact that sticks, whose slip is constant. `creep` outlives the expansion.
  void follow(const Creep& creep);

  /// Coefficient k of the force on the casing, newtons, along the contact's two fixed directions; to be
  /// called in their order, while the contact touches. Where it sticks, the holding friction's coefficient k
  /// is not in it yet.
  numerics::Twin force_term(int k);

  /// Whether the contact sticks or creeps: its slip is given, by a friction that the whole system decides.
  bool sticks() const { return sticks_; }
  /// Null where it does not creep.
  const Creep* creep() const { return creep_; }
  /// Normal where the expansion starts.
  double cosine() const { return law_->annular ? normal_[0][0] : 1; }
  double sine() const { return law_->annular ? normal_[0][1] : 0; }
  /// Coefficient k of (tangent at the start) . d'' that keeps the slip; `a1`, `a2` are those of d'' in the
  /// two fixed directions so far, without the holding friction's coefficient k.
  double keeping_term(int k) const;
  /// Sets coefficient k of the holding friction, and with it those of d''.
  void hold(int k, double force_n, numerics::Twin acceleration);
  /// Each coefficient twice.
  const numerics::PlaneSeries& holding() const { return holding_; }
  /// Coefficient k of the bound mu S -+ the holding friction, which is above zero as long as it holds.
  double reserve_term(int k, double sign) const {
    return law_->friction.holding * law_->stiffness * penetration_term(k) - sign * holding_.number(k);
  }

  const ContactLaw& law() const { return *law_; }
  contact::Mode mode() const { return mode_; }
  /// Angle per unit of time by which the normal turns where the expansion starts; zero at a flat stop.
  double turn_rate() const;
  /// Whether friction varies along the expansion, as viscous friction does and a tanh that is not saturated.
  bool friction_varies() const { return varies_; }

  // Results of an expansion that is complete up to `order`.

  /// Coefficient k <= order of the penetration; of an open annular contact (|d|^2 - C^2) / (2 C) instead,
  /// which rises through zero with it, after `make_open_penetration`.
  double penetration_term(int k) const {
    if (law_->annular && mode_ == contact::Mode::open) return open_penetration_[static_cast<std::size_t>(k)];
    return (law_->annular ? length_ : distance_).number(k) - (k == 0 ? law_->clearance : 0);
  }
  void make_open_penetration(int order);
  /// Its coefficients up to `order`, as `penetration_term`.
  void put_penetration(int order, double* to) const;
  /// Coefficients of d' . t up to order - 1, once `make_sliding` was called.
  void make_sliding(int order);
  double slip_term(int k) const;
  /// Steepness of the tanh that leaves saturation first, zero where none is saturated; the sign of the slip.
  double saturated_steepness() const { return saturated_steepness_; }
  double slip_sign() const { return slip_sign_; }

  // For the tangent vectors. Around the rotor: normal, r and r'.
  const numerics::PlaneSeries& normal() const { return normal_; }
  const numerics::PlaneSeries& length() const { return length_; }
  const numerics::PlaneSeries& length_rate() const { return length_rate_; }
  double inverse_length() const { return inverse_length_[0]; }  ///< where the expansion starts
  const numerics::Series& sliding() const { return sliding_; }
  /// Friction that varies: its coefficient, and the force that it is multiplied by (at a flat stop the first
  /// component of it).
  const numerics::PlaneSeries& coefficient() const { return mu_; }
  const numerics::PlaneSeries& load() const { return load_; }
  double constant_coefficient() const { return constant_mu_; }
  /// Coefficient k of d mu / d(sliding).
  double friction_slope_term(int k) const;
  /// Acceleration d'' in the two fixed directions, where the contact sticks.
  const numerics::PlaneSeries& acceleration() const { return acceleration_; }

 private:
  numerics::Twin flat_term(int k);
  numerics::Twin annular_term(int k);
  template <bool damped>
  numerics::Twin normal_and_rate(int k);
  void add_slip_term(double slip, int k);
  void add_sliding_term(int k);

  const ContactLaw* law_ = nullptr;
  contact::Mode mode_ = contact::Mode::open;
  // Coefficients of the law in this mode, each number twice, as products take it: factor of the spring,
  // damper, stiffness and clearance.
  numerics::Twin spring_factor_{}, damper_{}, stiffness_{}, clearance_{};
  bool varies_ = false, falls_ = false, sliding_made_ = false, sticks_ = false;
  const Creep* creep_ = nullptr;
  double sliding_speed_ = 0;
  double constant_mu_ = 0;      ///< of the terms that do not vary
  numerics::Twin turned_mu_{};  ///< (-mu, mu) of it: times a swapped pair, mu times that pair quarter turned
  double saturated_steepness_ = 0, slip_sign_ = 1;
  std::array<bool, 3> active_{};
  std::array<numerics::TanhSeries, 3> tanh_;
  numerics::FallSeries fall_;
  numerics::PlaneSeries distance_, velocity_, mu_, load_, holding_, acceleration_;
  // Annular: the normal; r and its rate; 1 / r where the expansion starts; while open, the substitute for the
  // penetration.
  numerics::PlaneSeries normal_, length_, length_rate_;
  numerics::Twin inverse_length_{};
  std::array<double, numerics::most_taylor_order + 1> open_penetration_{};
  numerics::Series sliding_;
};

}  // namespace rubsweep::integrate::taylor
