#pragma once

#include <array>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Parameters of a scaled contact that the power series of its forces use; none depends on the number of
/// coordinates.
struct ContactLaw {
  bool annular = false;
  double clearance = 0, stiffness = 0, damping = 0;
  double slip_scale_m_per_s = 0, surface_speed_m_per_s = 0;
  double mobility = 0;  ///< mobility as in ScaledContact
  contact::FrictionTerms friction;

  template <int N>
  explicit ContactLaw(const run::ScaledContact<N>& c)
      : annular(contact::annular(c.wall)),
        clearance(c.clearance),
        stiffness(c.stiffness),
        damping(c.damping),
        slip_scale_m_per_s(c.slip_scale_m_per_s),
        surface_speed_m_per_s(c.surface_speed_m_per_s),
        mobility(c.mobility()),
        friction(contact::friction_terms(c.friction)) {}

  /// Normal force = spring p + damper p' in this mode.
  double spring(contact::Mode mode) const { return contact::law_of(mode).spring * stiffness; }
  double damper(contact::Mode mode) const { return contact::law_of(mode).damper * damping; }
};

/// At |steepness slip| >= 20 a tanh is 1 to the last bit. A step that starts in this range treats the tanh as
/// constant. It ends, at the latest, at 19, where 1 - tanh(19) is 6e-17.
inline constexpr double saturated_at_start = 20, saturated_until = 19;

class Creep;

/// Motion and forces of one contact as power series of the time, within one contact mode. In its two fixed
/// directions the relative displacement is d = (d1, d2). In an annular stop r = |d|, and the normal is d / r.
class ContactSeries {
 public:
  /// Relative displacement, offset included, and the coefficients of its rate, which must be set in order:
  /// coefficient k before the call of `force_term(k)`.
  void set_distance(numerics::Twin distance) { distance_.set(0, distance); }
  void set_velocity(int k, numerics::Twin velocity) {
    velocity_.set(k, velocity);
    distance_.set(k + 1, velocity * numerics::one_over_twice(k + 1));
  }
  const numerics::PlaneSeries& distance() const { return distance_; }
  const numerics::PlaneSeries& velocity() const { return velocity_; }

  /// Starts an expansion in `mode` with the present slip, which decides which part of the friction is
  /// saturated. Dry friction instead depends on `way`, and is at its limit if `poised` (ContactStates).
  void begin(const ContactLaw& law, contact::Mode mode, double slip_m_per_s, contact::Slip way,
             bool poised = false);
  /// Makes the expansion keep the slip of `creep`, as for a sticking contact, whose slip is constant; the
  /// whole system determines the friction. `creep` must outlive the expansion.
  void follow(const Creep& creep);

  /// Coefficient k of the force on the casing, in newtons, along the contact's two fixed directions. Call it
  /// in order of k, while the contact touches. In a sticking contact it does not yet include coefficient k of
  /// the holding friction.
  numerics::Twin force_term(int k);

  /// Whether the contact sticks or creeps: its slip is given, and the whole system determines its friction.
  bool sticks() const { return sticks_; }
  /// Slip series of a creeping contact; null for others.
  const Creep* creep() const { return creep_; }
  /// Normal at the start of the expansion.
  double cosine() const { return law_->annular ? normal_[0][0] : 1; }
  double sine() const { return law_->annular ? normal_[0][1] : 0; }
  /// Coefficient k of (tangent at the start) . d'' that keeps the slip constant, computed from lower
  /// coefficients and without coefficient k of the holding friction.
  double keeping_term(int k) const;
  /// Sets coefficient k of the holding friction, and coefficient k of d'' that results from it.
  void hold(int k, double force_n, numerics::Twin acceleration);
  /// Holding friction, each coefficient stored twice.
  const numerics::PlaneSeries& holding() const { return holding_; }
  /// Coefficient k of the reserve mu S -+ holding friction, which is positive as long as friction holds.
  double reserve_term(int k, double sign) const {
    return law_->friction.holding * law_->stiffness * penetration_term(k) - sign * holding_.number(k);
  }

  const ContactLaw& law() const { return *law_; }
  contact::Mode mode() const { return mode_; }
  /// Angle per unit of time by which the normal turns at the start of the expansion; zero at a flat stop.
  double turn_rate() const;
  /// Whether friction varies along the expansion, as does viscous friction or an unsaturated tanh.
  bool friction_varies() const { return varies_; }

  // Results of an expansion that is complete up to `order`.

  /// Coefficient k <= order of the penetration. For an open annular contact it is that of (|d|^2 - C^2) / (2
  /// C), which crosses zero at the same instant; call `make_open_penetration` first.
  double penetration_term(int k) const {
    if (law_->annular && mode_ == contact::Mode::open) return open_penetration_[static_cast<std::size_t>(k)];
    return (law_->annular ? length_ : distance_).number(k) - (k == 0 ? law_->clearance : 0);
  }
  void make_open_penetration(int order);
  void put_penetration(int order, double* to) const;  ///< Writes `penetration_term` up to `order`.
  void make_sliding(int order);  ///< Computes the coefficients of d' . t up to order - 1, for `slip_term`.
  double slip_term(int k) const;
  /// Steepness of the tanh that leaves saturation first, zero if none is saturated; and the slip's sign.
  double saturated_steepness() const { return saturated_steepness_; }
  double slip_sign() const { return slip_sign_; }

  // For tangent vectors; the first three are for an annular stop: normal, r and r'.
  const numerics::PlaneSeries& normal() const { return normal_; }
  const numerics::PlaneSeries& length() const { return length_; }
  const numerics::PlaneSeries& length_rate() const { return length_rate_; }
  double inverse_length() const { return inverse_length_[0]; }  ///< at the start of the expansion
  const numerics::Series& sliding() const { return sliding_; }
  /// Varying friction: its coefficient, and the force that it multiplies (at a flat stop the first
  /// component).
  const numerics::PlaneSeries& coefficient() const { return mu_; }
  const numerics::PlaneSeries& load() const { return load_; }
  double constant_coefficient() const { return constant_mu_; }
  double friction_slope_term(int k) const;  ///< Coefficient k of d mu / d(sliding speed).
  /// Acceleration d'' in the two fixed directions of a sticking contact.
  const numerics::PlaneSeries& acceleration() const { return acceleration_; }

 protected:
  numerics::Twin flat_term(int k);
  numerics::Twin annular_term(int k);
  template <bool damped>
  numerics::Twin normal_and_rate(int k);
  /// Adds to coefficient k of the force at an annular stop the friction that holds it, but for coefficient k.
  numerics::Twin with_holding(numerics::Twin force, int k);
  void add_slip_term(double slip, int k);
  void add_sliding_term(int k);

  const ContactLaw* law_ = nullptr;
  contact::Mode mode_ = contact::Mode::open;
  // Coefficients of the law in this mode, each stored twice for products: factor of the spring, damper,
  // stiffness and clearance.
  numerics::Twin spring_factor_{}, damper_{}, stiffness_{}, clearance_{};
  bool varies_ = false, falls_ = false, sliding_made_ = false, sticks_ = false;
  const Creep* creep_ = nullptr;
  double sliding_speed_ = 0;
  double constant_mu_ = 0;  ///< friction coefficient of the constant terms
  /// (-mu, mu): its product with a swapped pair is mu times a quarter turn of the pair
  numerics::Twin turned_mu_{};
  double saturated_steepness_ = 0, slip_sign_ = 1;
  std::array<bool, 3> active_{};
  std::array<numerics::TanhSeries, 3> tanh_;
  numerics::FallSeries fall_;
  numerics::PlaneSeries distance_, velocity_, mu_, load_, holding_, acceleration_;
  // For annular stops: normal; r and its rate; 1 / r at the start of the expansion; and, while open, the
  // substitute for the penetration.
  numerics::PlaneSeries normal_, length_, length_rate_;
  numerics::Twin inverse_length_{};
  std::array<double, numerics::most_taylor_order + 1> open_penetration_{};
  numerics::Series sliding_;
};

}  // namespace rubsweep::integrate::taylor
