#pragma once

#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/numerics/taylor_series.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::taylor {

/// Derivative of the force of an annular contact with a constant friction coefficient, as power series along
/// an expanded motion. A small change w of the relative displacement changes the force by (B w)' + A w. With
/// the normal n, T = 1 - n n^T, the distance r, the friction coefficient mu, a quarter turn Q, and in the
/// contact's mode the factor s of the spring K and the damper D:
/// B = D n n^T,  A = K (s + mu Q) (1 - C T / r) + D (r' T / r - n' n^T).
/// This is the variation of the force s K (d - C n) + mu K Q (d - C n) + D r' n of ContactSeries. Many
/// tangent vectors share A and B, and each then costs only these products.
class ContactJacobian {
 public:
  using Twin = numerics::Twin;

  /// Starts with the contact's present expansion; no term is computed yet.
  void follow(const ContactSeries& contact) {
    contact_ = &contact;
    made_ = 0;
  }
  /// Computes the missing terms up to k (of B up to k + 1), as far as the normal of the motion is known.
  void extend(int k) {
    while (made_ <= k) make(made_++);
  }

  /// Whether the contact is damped. Valid, like the functions below, once a term is computed.
  bool damped() const { return damper_ != 0; }
  /// Coefficients of the columns of A, and of B where damped.
  Twin first(int k) const { return first_[k]; }
  Twin second(int k) const { return second_[k]; }
  Twin first_damped(int k) const { return first_damped_[k]; }
  Twin second_damped(int k) const { return second_damped_[k]; }

 private:
  void read_law();
  void make(int k);
  void make_along(int k);
  Twin spring_column(double along, double across) const;

  const ContactSeries* contact_ = nullptr;
  int made_ = 0;
  double spring_ = 0, friction_ = 0, damper_ = 0, clearance_ = 0;
  /// n1 twice; first column of n n^T; 1 / r twice; first columns of T and of T / r.
  numerics::PlaneSeries normal_first_, along_, inverse_, across_, bend_;
  /// (r', n1') and (1 / r, n2): factors that are multiplied side by side.
  numerics::PlaneSeries rates_, factors_;
  numerics::PlaneSeries first_, second_, first_damped_, second_damped_;
};

}  // namespace rubsweep::integrate::taylor
