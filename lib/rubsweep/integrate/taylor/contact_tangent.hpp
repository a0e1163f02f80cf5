#pragma once

#include <array>

#include "rubsweep/integrate/taylor/contact_series.hpp"
#include "rubsweep/numerics/plane_series.hpp"
#include "rubsweep/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Change of a contact's force with a small change w of its relative displacement, as a power series along an
/// expanded motion: the derivatives of the very recurrences that ContactSeries goes by. The friction that
/// holds a contact that sticks counts as given.
class ContactTangent {
 public:
  /// Up to `order` terms. The motion stays as it is until the last `force_term` has been asked for.
  void follow(const ContactSeries& contact, int order);
  /// Another change of the same motion begins.
  void begin(numerics::Twin displacement);

  /// Coefficient k of the force's change, from coefficient k of w'; asked for in their order. Writes
  /// coefficient k + 1 of w.
  numerics::Twin force_term(int k, numerics::Twin rate);

  /// w, up to one more than the last term asked for.
  const numerics::PlaneSeries& displacement() const { return displacement_; }
  /// Change of r of an annular stop, as far; each coefficient twice.
  const numerics::PlaneSeries& length() const { return length_; }
  /// Coefficient k of the change of the spring force.
  double load_term(int k) const { return stiffness_ * (annular_ ? length_.number(k) : displacement_[k][0]); }

 private:
  numerics::Twin flat_term(int k);
  numerics::Twin annular_term(int k);
  template <bool damped>
  numerics::Twin normal_and_rate(int k);
  /// Of the friction coefficient, from that of the sliding speed.
  numerics::Twin coefficient_term(double sliding, int k);

  const ContactSeries* contact_ = nullptr;
  double stiffness_ = 0, spring_factor_ = 0, damper_ = 0, clearance_ = 0, friction_ = 0;
  bool varies_ = false, sticks_ = false, annular_ = false;
  numerics::PlaneSeries displacement_, rate_;
  /// Changes: of r, of r', of the normal, of the force that friction is multiplied by; of the sliding speed
  /// and the friction coefficient. Then the friction coefficient's slope, which is the motion's.
  numerics::PlaneSeries length_, length_rate_, normal_, load_, sliding_, coefficient_, slope_;
};

}  // namespace rubsweep::integrate::taylor
