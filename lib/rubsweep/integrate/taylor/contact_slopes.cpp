#include "rubsweep/integrate/taylor/contact_slopes.hpp"

namespace rubsweep::integrate::taylor {

using numerics::product_term;
using numerics::Series;
using numerics::square_term;

void ContactSlopes::make(ContactSeries& contact, int order) {
  const ContactLaw& law = contact.law();
  has_rate_ = law.damper(contact.mode()) != 0 || contact.friction_varies();
  if (law.annular) {
    terms_ = order + 1;
    make_annular(contact, order);
    if (has_rate_) make_damping(contact, order);
  } else {
    terms_ = contact.friction_varies() ? order + 1 : 1;
    make_flat(contact, order);
  }
}

/// Normal force K (factor p) + d v, friction mu(slip) K p.
void ContactSlopes::make_flat(const ContactSeries& contact, int order) {
  const ContactLaw& law = contact.law();
  const double spring = law.spring(contact.mode());
  if (contact.friction_varies()) {
    for (int k = 0; k <= order; ++k) {
      slope_.set(k, contact.friction_slope_term(k));
      spring_.set(k, law.stiffness * contact.penetration_term(k));
    }
  }
  for (int k = 0; k < terms_; ++k) {
    const bool first = k == 0;
    by_d_[0].set(k, first ? spring : 0);
    by_d_[1].set(k, 0);
    by_d_[2].set(k, law.stiffness * (contact.friction_varies() ? contact.coefficient()[k]
                                     : first                   ? contact.constant_coefficient()
                                                               : 0));
    by_d_[3].set(k, 0);
    by_rate_[0].set(k, first ? law.damper(contact.mode()) : 0);
    by_rate_[1].set(k, 0);
    by_rate_[2].set(k, 0);
    by_rate_[3].set(k, contact.friction_varies() ? product_term(slope_, spring_, k) : 0);
  }
}

/// f = F n + mu S t with n' = t (t . d') / r and t' = -n (t . d') / r. In n and t,
///   df/dd = F_p n n^T + (F_v sigma / r - mu S / r) n t^T + mu K t n^T + (F / r - mu_v S p' / r) t t^T
/// with sigma the sliding speed. The products of n and t are half of one and of cosine and sine of twice the
/// normal's angle: so are the four entries.
void ContactSlopes::make_annular(ContactSeries& contact, int order) {
  const ContactLaw& law = contact.law();
  const double normal = law.spring(contact.mode());
  const double damper = law.damper(contact.mode());
  const bool varies = contact.friction_varies();
  const Series &q = contact.inverse_length(), &e = contact.spring_over_length();
  if (damper != 0) contact.make_sliding(order + 1);
  const auto mu_e_term = [&](int k) {
    if (contact.sticks()) return product_term(contact.holding(), q, k);
    return varies ? product_term(contact.coefficient(), e, k) : contact.constant_coefficient() * e[k];
  };
  for (int k = 0; k <= order; ++k) {
    cx_.set(k, product_term(contact.d1, q, k));
    cy_.set(k, product_term(contact.d2, q, k));
    c2_.set(k, square_term(cx_, k) - square_term(cy_, k));
    s2_.set(k, 2 * product_term(cx_, cy_, k));
    double x = -mu_e_term(k), z = contact.total_over_length()[k];
    if (damper != 0) x += damper * product_term(contact.sliding(), q, k);
    if (varies) {
      slope_.set(k, contact.friction_slope_term(k));
      length_rate_.set(k, (k + 1) * contact.length()[k + 1]);
      friction_rate_.set(k, product_term(slope_, e, k));
      z -= product_term(friction_rate_, length_rate_, k);
    }
    const double y = law.stiffness * (varies   ? contact.coefficient()[k]
                                      : k == 0 ? contact.constant_coefficient()
                                               : 0);
    const double tp = k == 0 ? normal : 0;
    even_.set(k, tp - z);
    odd_.set(k, x + y);
    const double c = product_term(even_, c2_, k) - product_term(odd_, s2_, k);
    const double s = product_term(odd_, c2_, k) + product_term(even_, s2_, k);
    by_d_[0].set(k, (tp + z + c) / 2);
    by_d_[3].set(k, (tp + z - c) / 2);
    by_d_[1].set(k, (s + x - y) / 2);
    by_d_[2].set(k, (s - x + y) / 2);
  }
}

/// df/dd' = F_v n n^T + mu_v S t t^T.
void ContactSlopes::make_damping(const ContactSeries& contact, int order) {
  const ContactLaw& law = contact.law();
  const double damper = law.damper(contact.mode());
  const bool varies = contact.friction_varies();
  for (int k = 0; k <= order; ++k) {
    if (varies) spring_.set(k, law.stiffness * contact.penetration_term(k));
    const double normal = k == 0 ? damper : 0, tangent = varies ? product_term(slope_, spring_, k) : 0;
    even_.set(k, normal - tangent);
    const double c = product_term(even_, c2_, k), s = product_term(even_, s2_, k);
    by_rate_[0].set(k, (normal + tangent + c) / 2);
    by_rate_[3].set(k, (normal + tangent - c) / 2);
    by_rate_[1].set(k, s / 2);
    by_rate_[2].set(k, s / 2);
  }
}

}  // namespace rubsweep::integrate::taylor
