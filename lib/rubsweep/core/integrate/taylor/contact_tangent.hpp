#pragma once

#include <cstddef>

#include "rubsweep/core/integrate/taylor/contact_jacobian.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Tangent vectors that are expanded side by side: the products of one do not keep a processor busy, and
/// those of more need more than its sixteen registers.
inline constexpr int tangents_together = 4;

/// Variations of a contact's force with `Count` small changes w of its relative displacement, as power series
/// along an expanded motion: the derivatives of the recurrences of ContactSeries, or, for several around the
/// rotor where friction does not vary, the Jacobian's product with each. The friction that holds a contact
/// that sticks counts as given.
template <int Count>
class ContactTangents {
 public:
  using Bundle = numerics::PlaneSeriesBundle<Count>;
  using Term = typename Bundle::Term;

  /// Up to `order` terms. The motion stays as it is until the last `force_term` has been asked for;
  /// `jacobian` is of it, too.
  void follow(const ContactSeries& contact, ContactJacobian& jacobian, int order);
  /// Begins other variations of the same motion.
  void begin(const Term& displacement);

  /// Coefficient k of the forces' variations, from coefficient k of w'; to be called in their order. Writes
  /// coefficient k + 1 of w.
  Term force_term(int k, const Term& rate);

  /// w, up to one more than the last term asked for; not kept where the Jacobian serves, nor is what follows.
  const Bundle& displacement() const { return displacement_; }
  /// Coefficient k of the variation of r of an annular stop, up to the last term as well.
  double length_term(std::size_t which, int k) const { return length_.member(which)[k][0]; }
  /// Coefficient k of the variation of the spring force.
  double load_term(std::size_t which, int k) const {
    return stiffness_ * (annular_ ? length_term(which, k) : displacement_.member(which)[k][0]);
  }

 private:
  Term flat_term(int k);
  Term annular_term(int k);
  template <bool damped>
  Term linear_term(int k);
  void put(int k, std::size_t which, numerics::Twin displacement);
  template <bool damped>
  Term normal_and_rate(int k);
  Term damping_products(int k) const;
  numerics::Twin sliding_friction(std::size_t which, numerics::Twin load, int k);
  /// Coefficient k of the variation of mu, from that of the sliding speed.
  void add_coefficient_term(std::size_t which, double sliding, int k);

  static constexpr auto count = static_cast<std::size_t>(Count);
  const ContactSeries* contact_ = nullptr;
  double stiffness_ = 0, spring_factor_ = 0, damper_ = 0, clearance_ = 0, friction_ = 0;
  /// `linear_`: by the Jacobian, which costs as much as one or two vectors.
  bool varies_ = false, sticks_ = false, annular_ = false, linear_ = false;
  ContactJacobian* jacobian_ = nullptr;
  Bundle displacement_, rate_;
  Bundle along_first_, along_second_;  ///< bundles of a linear contact: either component of w, twice
  /// Variations: of r, of r', of the normal, of the force that friction is proportional to; of the sliding
  /// speed and the friction coefficient. Then the slope of the friction coefficient, which is the motion's.
  Bundle length_, length_rate_, normal_, load_, sliding_, coefficient_;
  numerics::PlaneSeries slope_;
};

extern template class ContactTangents<1>;
extern template class ContactTangents<tangents_together>;

}  // namespace rubsweep::integrate::taylor
