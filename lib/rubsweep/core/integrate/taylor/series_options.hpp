#pragma once

#include "rubsweep/core/numerics/taylor_series.hpp"

namespace rubsweep::integrate::taylor {

/// Rounding of a sum relative to the last terms of a series: at the end of a step each term is about a fourth
/// of the one before, so that they may be four times as large as the truncation error.
inline constexpr double rounding_of_series = 0x1p-51;

/// How a motion is made of power series.
struct SeriesOptions {
  int order = numerics::most_taylor_order;
  /// A step ends where the last two terms come to this share of the motion's size. Above rounding the steps
  /// are longer, and the motion is as good as this.
  double accuracy = rounding_of_series;
  /// Ratio `Dynamics::friction_ratio` above which contacts creep: sweeps cost as much as a dozen usual
  /// pieces, whose length falls with the ratio, and converge by it.
  double creep_above = 20;
};

}  // namespace rubsweep::integrate::taylor
