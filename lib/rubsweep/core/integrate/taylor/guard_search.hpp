#pragma once

#include <cstddef>
#include <optional>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"

namespace rubsweep::integrate::taylor {

/// A guard of one contact that rises through zero.
struct GuardCrossing {
  double share = 1;  ///< of the duration that was searched
  contact::Mode next = contact::Mode::open;
};

// `order` and `accuracy` below are those of SeriesOptions.

/// The longest duration, at most `duration_rad`, over which the guards of a contact are their polynomials to
/// `accuracy`. |d| and its square have series that end later than those of d: a step that is right for the
/// motion may be too long for them. To be asked before `first_guard`.
double guards_converged_rad(ContactSeries& contact, int order, double accuracy, double duration_rad);

/// The first armed guard of a contact that rises through zero within `duration_rad` of an expansion; the
/// guards are polynomials there and none is passed over.
std::optional<GuardCrossing> first_guard(const ContactSeries& contact, int order, double accuracy,
                                         double duration_rad);

/// End of sliding in one direction, or of sticking, of a contact with dry friction.
struct SlipEvent {
  double share = 1;  ///< of the duration that was searched
  /// Sticking: the slip has come to zero, and stick or slip has to be decided anew. Else the direction in
  /// which a contact slides that friction no longer holds.
  contact::Slip next = contact::Slip::sticking;
};

/// Knowledge of a slip at the start of an expansion.
struct SlipStart {
  /// Number of leading coefficients that are zero but for rounding, because the slip has just begun.
  int zero_terms = 0;
  /// Distance from zero (clearances a radian) at which a slip that others hold at zero stops, where it moves
  /// against its friction. Zero for any other slip.
  double poised_within = 0;
};

/// The first such end of a contact with dry friction that touches.
std::optional<SlipEvent> first_slip_event(ContactSeries& contact, int order, double accuracy,
                                          double duration_rad, const SlipStart& start);

/// Rate, `duration_rad` into an expansion, of the friction that a contact which sticks has left in the
/// direction of `slip`.
double reserve_rate(const ContactSeries& contact, int order, double duration_rad, contact::Slip slip);

/// The share of `duration_rad` up to which every tanh that the expansion takes as constant is one; 1 where
/// all of it is.
double saturated_share(ContactSeries& contact, int order, double duration_rad);

/// Whether the slip of a touching contact is zero or below anywhere in the duration.
bool slip_reverses(ContactSeries& contact, int order, double duration_rad);

}  // namespace rubsweep::integrate::taylor
