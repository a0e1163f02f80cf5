#pragma once

#include <array>

#include "rubsweep/integrate/taylor/contact_series.hpp"
#include "rubsweep/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Derivatives of a touching contact's force by d and by d', as power series along an expanded motion: each a
/// matrix of two rows in the contact's fixed directions. The friction that holds a contact that sticks counts
/// as given.
class ContactSlopes {
 public:
  /// Up to `order`, from the series of a motion expanded further than that.
  void make(ContactSeries& contact, int order);

  /// Coefficients beyond `terms` are zero: a linear law has one.
  int terms() const { return terms_; }
  /// Row by row.
  const std::array<numerics::Series, 4>& by_d() const { return by_d_; }
  const std::array<numerics::Series, 4>& by_rate() const { return by_rate_; }
  bool has_rate() const { return has_rate_; }
  /// Normal of an annular stop.
  const numerics::Series& cosine() const { return cx_; }
  const numerics::Series& sine() const { return cy_; }

 private:
  void make_flat(const ContactSeries& contact, int order);
  void make_annular(ContactSeries& contact, int order);
  void make_damping(const ContactSeries& contact, int order);

  std::array<numerics::Series, 4> by_d_, by_rate_;
  int terms_ = 0;
  bool has_rate_ = false;
  numerics::Series cx_, cy_, c2_, s2_, slope_, spring_, friction_rate_, length_rate_, even_, odd_;
};

}  // namespace rubsweep::integrate::taylor
