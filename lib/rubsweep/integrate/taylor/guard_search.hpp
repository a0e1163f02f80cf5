#pragma once

#include <cstddef>
#include <optional>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/integrate/taylor/contact_series.hpp"

namespace rubsweep::integrate::taylor {

/// A guard of one contact that rises through zero.
struct GuardCrossing {
  double share = 1;  ///< of the duration that was searched
  contact::Mode next = contact::Mode::open;
};

/// The first armed guard of a contact that rises through zero within `duration_rad` of an expansion of order
/// `order`; the guards are polynomials there and none is passed over.
std::optional<GuardCrossing> first_guard(const ContactSeries& contact, int order, double duration_rad);

/// The share of `duration_rad` up to which every tanh that the expansion takes as constant is one; 1 where
/// all of it is.
double saturated_share(ContactSeries& contact, int order, double duration_rad);

/// Whether the slip of a touching contact is zero or below anywhere in the duration.
bool slip_reverses(ContactSeries& contact, int order, double duration_rad);

}  // namespace rubsweep::integrate::taylor
