#pragma once

#include <array>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/contact/dry_friction.hpp"
#include "rubsweep/integrate/taylor/contact_law.hpp"
#include "rubsweep/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Motion and forces of one contact as power series of the time, within one contact mode. In its two fixed
/// directions the relative displacement is d = (d1, d2); around the rotor r = |d| and the normal is d / r.
class ContactSeries {
 public:
  struct Force {
    double first = 0, second = 0;  ///< on the casing, newtons, along the contact's two fixed directions
  };

  /// Relative displacement, offset included. Whoever expands the motion writes coefficient k + 1 before
  /// `force_term(k)` is asked for.
  numerics::Series d1, d2;

  /// Starts an expansion in `mode` with the slip there, which says what of the friction is saturated. Dry
  /// friction goes by `way` instead.
  void begin(const ContactLaw& law, contact::Mode mode, double slip_m_per_s, contact::Slip way);

  /// Coefficient k of the force; coefficients are asked for in their order. The contact touches. Where it
  /// sticks, the holding friction's coefficient k is not in it yet.
  Force force_term(int k);

  /// The contact sticks: its slip keeps its value by a friction that the system as a whole decides.
  bool sticks() const { return sticks_; }
  /// Normal where the expansion starts.
  double cosine() const { return law_->annular ? d1[0] * q_[0] : 1; }
  double sine() const { return law_->annular ? d2[0] * q_[0] : 0; }
  /// Coefficient k of (tangent at the start) . d'' that keeps the slip; `a1`, `a2` are those of d'' in the
  /// two fixed directions so far, without the holding friction's coefficient k.
  double keeping_term(int k) const;
  /// That coefficient of the holding friction, and with it those of d''.
  void hold(int k, double force_n, double a1, double a2);
  const numerics::Series& holding() const { return holding_; }
  /// Coefficient k of mu S -+ the holding friction, which is above zero as long as it holds.
  double reserve_term(int k, double sign) const {
    return law_->friction.dry * law_->stiffness * penetration_term(k) - sign * holding_[k];
  }

  const ContactLaw& law() const { return *law_; }
  contact::Mode mode() const { return mode_; }
  /// Angle per unit of time by which the normal turns where the expansion starts; zero at a flat stop.
  double turn_rate() const;
  /// Slope of a tanh that is not saturated changes along the expansion, and so does viscous friction.
  bool friction_varies() const { return varies_; }

  // What is known once the expansion is complete up to `order`.

  /// Coefficient k <= order of the penetration; of an open annular contact (|d|^2 - C^2) / (2 C) instead,
  /// which rises through zero with it, after `make_open_penetration`.
  double penetration_term(int k) const;
  void make_open_penetration(int order);
  /// Coefficients of d' . t up to order - 1, once `make_sliding` was called.
  void make_sliding(int order);
  double slip_term(int k) const;
  /// Steepness of the tanh that leaves saturation first, zero where none is saturated; the sign of the slip.
  double saturated_steepness() const { return saturated_steepness_; }
  double slip_sign() const { return slip_sign_; }

  // For the slopes of the force.
  const numerics::Series& inverse_length() const { return q_; }
  const numerics::Series& spring_over_length() const { return e_; }
  const numerics::Series& total_over_length() const { return alpha_; }
  const numerics::Series& length() const { return r_; }
  const numerics::Series& sliding() const { return sliding_; }
  /// Of d'' in the two fixed directions, where the contact sticks.
  const numerics::Series& first_acceleration() const { return a1_; }
  const numerics::Series& second_acceleration() const { return a2_; }
  const numerics::Series& coefficient() const { return mu_; }
  double constant_coefficient() const { return constant_mu_; }
  /// Coefficient k of d mu / d(sliding).
  double friction_slope_term(int k) const;

 private:
  Force flat_term(int k);
  Force annular_term(int k);
  void add_slip_term(double slip, int k);
  void add_sliding_term(int k);
  bool damped() const { return damper_ != 0; }

  const ContactLaw* law_ = nullptr;
  contact::Mode mode_ = contact::Mode::open;
  double spring_factor_ = 0, damper_ = 0;
  bool varies_ = false, sliding_made_ = false, sticks_ = false;
  double sliding_speed_ = 0;
  double constant_mu_ = 0;  ///< of the terms that do not vary
  double saturated_steepness_ = 0, slip_sign_ = 1;
  std::array<bool, 3> active_{};
  std::array<numerics::TanhSeries, 3> tanh_;
  numerics::Series mu_, spring_, holding_, a1_, a2_, holding_over_length_;
  // Annular: squared length, length, its inverse; K (r - C) / r; (total normal force) / r.
  numerics::Series s_, r_, q_, e_, alpha_, length_rate_;
  numerics::Series zx_, zy_, v1_, v2_, cross_, sliding_;
};

}  // namespace rubsweep::integrate::taylor
