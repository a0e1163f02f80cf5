#pragma once

#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Rounding of a sum, relative to the last terms of a series. At the end of a step each term is about a
/// fourth of the one before, so that the last terms may be four times the truncation error.
inline constexpr double rounding_of_series = 0x1p-51;

/// Settings of the power series of a motion.
struct SeriesOptions {
  int order = numerics::most_taylor_order;
  /// A step ends where the last two terms reach this share of the motion's size. A value above rounding gives
  /// longer steps and is then the accuracy of the motion.
  double accuracy = rounding_of_series;
  /// Value of `Dynamics::friction_ratio` above which contacts creep. Sweeps cost as much as a dozen usual
  /// pieces; a larger ratio shortens usual pieces and makes sweeps converge faster.
  double creep_above = 20;
};

}  // namespace rubsweep::integrate::taylor
