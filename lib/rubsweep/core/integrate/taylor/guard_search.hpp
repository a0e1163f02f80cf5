#pragma once

#include <optional>
#include <span>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"

namespace rubsweep::integrate::taylor {

/// Crossing of a contact's guard that rises through zero.
struct GuardCrossing {
  double share = 1;  ///< share of the searched duration
  contact::Mode next = contact::Mode::open;
};

// The parameters `order` and `accuracy` below are those of SeriesOptions.

/// The longest duration, at most `duration_rad`, over which the polynomials of a contact's guards are
/// accurate to `accuracy`. The series of |d| and its square converge more slowly than that of d, so that a
/// step that suits the motion may be too long for them. Call it before `first_guard`.
double guards_converged_rad(ContactSeries& contact, int order, double accuracy, double duration_rad);

/// First armed guard of a contact that rises through zero within `duration_rad` of an expansion. Guards are
/// polynomials there, and none is missed.
std::optional<GuardCrossing> first_guard(const ContactSeries& contact, int order, double accuracy,
                                         double duration_rad);

/// First rise through zero, as a share of the searched duration, of an armed guard with these coefficients,
/// which change. Share 0: it is past zero at the start and rises.
std::optional<double> first_rise(std::span<double> coefficients, double accuracy);

/// Event at a contact with dry friction: the end of sliding in one direction, or of sticking.
struct SlipEvent {
  double share = 1;  ///< share of the searched duration
  /// sticking: the slip has reached zero, and stick or slip must be decided anew. Otherwise: direction in
  /// which a contact begins to slide because friction no longer holds it.
  contact::Slip next = contact::Slip::sticking;
};

/// Properties of a slip at the start of an expansion.
struct SlipStart {
  /// Number of leading coefficients that are zero except for rounding, because the slip has just begun.
  int zero_terms = 0;
  /// Distance from zero, in clearances per radian, at which a poised slip that moves against its friction
  /// stops. Zero for any other slip.
  double poised_within = 0;
};

/// First slip event of a touching contact with dry friction.
std::optional<SlipEvent> first_slip_event(ContactSeries& contact, int order, double accuracy,
                                          double duration_rad, const SlipStart& start);

/// Rate, `duration_rad` into an expansion, of the friction reserve of a sticking contact in the direction of
/// `slip`.
double reserve_rate(const ContactSeries& contact, int order, double duration_rad, contact::Slip slip);

/// Share of `duration_rad` up to which every tanh that the expansion takes as constant still equals 1; 1 if
/// this holds over the whole duration.
double saturated_share(ContactSeries& contact, int order, double duration_rad);

/// Whether the slip of a touching contact is <= 0 at some time in the duration.
bool slip_reverses(ContactSeries& contact, int order, double duration_rad);

}  // namespace rubsweep::integrate::taylor
