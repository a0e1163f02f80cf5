#pragma once

#include <array>
#include <cmath>

#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Force K p^n whose n is a half of an integer, by a scaled penetration.
struct PowerLaw {
  int halves = 0;     ///< 2 n; 0 for any other law
  double factor = 0;  ///< K, in newtons

  PowerLaw(const contact::CurvedLaw* law, double length_m);

  /// Whether the root of the penetration, but not the penetration itself, has a power series where the
  /// contact begins.
  bool rooted() const { return halves % 2 == 1; }
  double force_n(double penetration) const { return factor * std::pow(penetration, halves / 2.0); }
  double slope(double penetration) const {
    return factor * halves / 2 * std::pow(penetration, halves / 2.0 - 1);
  }
};

/// Motion and forces of a contact with such a law as power series of the time of RegularExpansion. Rates are
/// by the phase.
class RegularContact : public ContactSeries {
 public:
  explicit RegularContact(const PowerLaw& power) : power_(power) {}

  /// Sets coefficient k of the relative displacement, offset included, and of its rate.
  void set_motion(int k, numerics::Twin distance, numerics::Twin velocity) {
    distance_.set(k, distance);
    velocity_.set(k, velocity);
  }
  /// After `begin`: the c of the force K p^n (1 + c p') of the present impact, and whether the root of the
  /// penetration is the pace.
  void begin_power(double damping, bool is_pace) {
    damping_ = numerics::both(damping);
    is_pace_ = is_pace;
  }
  /// Coefficient k of the force, as ContactSeries::force_term.
  numerics::Twin power_term(int k);
  /// Computes coefficient k + 1 of r, and of the root if it is the pace. `pace` is known up to k; null: 1.
  void advance(int k, const numerics::Series* pace);

  const PowerLaw& power() const { return power_; }
  const numerics::Series& root() const { return root_; }
  bool is_pace() const { return is_pace_; }
  double closing_term(int k) const { return law_->annular ? length_rate_.number(k) : velocity_[k][0]; }
  double impact_damping() const { return damping_[0]; }

 private:
  double spring_term(int k);

  PowerLaw power_;
  bool is_pace_ = false;
  numerics::Twin damping_{};
  numerics::Series penetration_, root_;
  std::array<numerics::Series, 2> products_;  ///< up to the power of the penetration
  numerics::PlaneSeries spring_;              ///< elastic force
};

}  // namespace rubsweep::integrate::taylor
