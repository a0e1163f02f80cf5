#pragma once

#include <cmath>

#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Force K p^n by a scaled penetration.
struct PowerLaw {
  double exponent = 0;  ///< n; 0 for any other law
  int halves = 0;       ///< 2 n if it is an integer, otherwise 0
  double factor = 0;    ///< K, in newtons

  PowerLaw(const contact::CurvedLaw* law, double length_m) {
    if (!law || law->law().kind != model::ForceCurve::power) return;
    exponent = law->law().exponent;
    if (2 * exponent == std::floor(2 * exponent)) halves = static_cast<int>(2 * exponent);
    rooted_ = halves % 2 == 1;
    factor = law->law().stiffness_n_per_m_n * std::pow(length_m, exponent);
  }

  /// Whether the root of the penetration, but not the penetration itself, has a power series where the
  /// contact begins.
  bool rooted() const { return rooted_; }
  /// Whether the force has a power series of the penetration where the contact begins.
  bool whole() const { return halves > 0 && !rooted_; }
  double force_n(double penetration) const { return slope(penetration) * penetration / exponent; }
  double slope(double penetration) const {
    if (halves == 0) return factor * exponent * std::pow(penetration, exponent - 1);
    const double root = rooted() ? std::sqrt(penetration) : 1;
    return factor * halves / 2 * root * numerics::power(penetration, halves / 2 - 1);
  }

 private:
  bool rooted_ = false;
};

/// Motion and forces of a contact with such a law as power series of the time of RegularExpansion. Rates are
/// by the phase.
class RegularContact : public ContactSeries {
 public:
  explicit RegularContact(const PowerLaw& power) : power_(power) {}

  // Set coefficient k of the relative displacement, offset included, and of its rate.
  void set_distance(int k, numerics::Twin distance) { distance_.set(k, distance); }
  void set_velocity(int k, numerics::Twin velocity) { velocity_.set(k, velocity); }
  /// After `begin`: the c of the force K p^n (1 + c p') of the present impact, and whether the root of the
  /// penetration is the pace.
  void begin_power(double damping, bool is_pace) {
    damping_ = damping, is_pace_ = is_pace, by_quotient_ = !power_.whole() && !is_pace;
  }
  /// After `begin_power`, with 2 n an integer: a contact's root is the pace.
  void follow_pace() { by_quotient_ = false; }
  /// Coefficient k of the force, as ContactSeries::force_term.
  numerics::Twin power_term(int k) { return law_->annular ? round_term(k) : straight_term(k); }
  /// Computes coefficient k + 1 of r, of the root if it is the pace, and of the relative displacement without
  /// a pace. `pace` is known up to k; null: 1.
  void advance(int k, const numerics::Series* pace) {
    const double closing = rates_[k][1], next = numerics::one_over(k + 1);
    if (!pace) distance_.set(k + 1, velocity_[k] * numerics::one_over_twice(k + 1));
    if (law_->annular) {
      closing_.set(k, closing);
      length_.set(k + 1, (pace ? product_term(closing_, *pace, k) : closing) * next);
    }
    if (is_pace_) root_.set(k + 1, closing * next / 2);
  }

  const PowerLaw& power() const { return power_; }
  const numerics::Series& root() const { return root_; }
  bool is_pace() const { return is_pace_; }
  double closing_term(int k) const { return rates_[k][1]; }
  double impact_damping() const { return damping_; }
  double spring_term(int k) const { return factors_[k][1]; }  ///< Coefficient k of the elastic force S.
  /// Coefficient k of S' and of S, after `power_term`, in order of k.
  numerics::Twin elastic_term(int k);

 private:
  double factor_term(int k, double penetration);
  numerics::Twin normal_term(int k, numerics::Twin newest, numerics::Twin products);
  numerics::Twin straight_term(int k);
  numerics::Twin round_term(int k);

  PowerLaw power_;
  bool is_pace_ = false, by_quotient_ = false;  ///< by_quotient_: far from p = 0, without the root
  double damping_ = 0, twice_root_inverse_ = 0, penetration_inverse_ = 0, damper_term_ = 0;
  numerics::Series penetration_, root_, closing_;
  /// (p^n / p, S), by quotient (S, S), and (p, p'): factors that are multiplied side by side. N and S at an
  /// annular stop. S' by quotient.
  numerics::PlaneSeries factors_, rates_, pressed_, spring_, slope_;
};

}  // namespace rubsweep::integrate::taylor
