#pragma once

#include <cstddef>

#include "rubsweep/core/integrate/taylor/contact_jacobian.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Number of tangent vectors that are expanded side by side. Fewer do not keep a processor busy, and more
/// need more than its sixteen registers.
inline constexpr int tangents_together = 4;

/// Variations of a contact's force for `Count` small changes w of its relative displacement, as power series
/// along an expanded motion. They are derivatives of the recurrences of ContactSeries, or, for several
/// vectors at an annular stop with constant friction, products with its Jacobian. The holding friction of a
/// sticking contact is not varied here.
template <int Count>
class ContactTangents {
 public:
  using Bundle = numerics::PlaneSeriesBundle<Count>;
  using Term = typename Bundle::Term;

  /// Prepares up to `order` terms. The motion must not change until the last call of `force_term`; `jacobian`
  /// must belong to the same motion.
  void follow(const ContactSeries& contact, ContactJacobian& jacobian, int order);
  void begin(const Term& displacement);  ///< Begins with other variations along the same motion.

  /// Coefficient k of the variations of the forces, from coefficient k of w'; call it in order of k. Writes
  /// coefficient k + 1 of w.
  Term force_term(int k, const Term& rate);

  /// Bundle w, up to one order above the latest term. Not kept, like the functions below, when the Jacobian
  /// is used.
  const Bundle& displacement() const { return displacement_; }
  /// Coefficient k of the variation of r in an annular stop, up to the latest term.
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
  /// Coefficient k of the variation of mu, from that of the variation of the sliding speed.
  void add_coefficient_term(std::size_t which, double sliding, int k);

  static constexpr auto count = static_cast<std::size_t>(Count);
  const ContactSeries* contact_ = nullptr;
  double stiffness_ = 0, spring_factor_ = 0, damper_ = 0, clearance_ = 0, friction_ = 0;
  /// `linear_`: uses the Jacobian, which costs as much as one or two vectors.
  bool varies_ = false, sticks_ = false, annular_ = false, linear_ = false;
  ContactJacobian* jacobian_ = nullptr;
  Bundle displacement_, rate_;
  Bundle along_first_, along_second_;  ///< for a linear contact: first and second component of w, each twice
  /// Variations of r, r', the normal, the force to which friction is proportional, the sliding speed and the
  /// friction coefficient. `slope_`: slope of the friction coefficient along the motion.
  Bundle length_, length_rate_, normal_, load_, sliding_, coefficient_;
  numerics::PlaneSeries slope_;
};

extern template class ContactTangents<1>;
extern template class ContactTangents<tangents_together>;

}  // namespace rubsweep::integrate::taylor
