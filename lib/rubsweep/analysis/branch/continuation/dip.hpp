#pragma once

#include <optional>

namespace rubsweep::branch::continuation {

/// A smooth function at both ends of a step: its values, and its slopes per unit of the step's length.
struct StepEnds {
  double begin = 0, end = 0;
  double begin_slope = 0, end_slope = 0;
};

/// Where between the ends, as a share of the step, a function should be looked at because it may have two
/// roots more than its signs at the ends tell: the cubic through `ends` comes as near to zero there as
/// half of the nearer end, or beyond it. Empty where it does not. `length` > 0: of the step.
std::optional<double> dip_of_cubic(const StepEnds& ends, double length);

/// The same share for a function with these values at the ends and this mean in between, by a quadratic.
std::optional<double> dip_of_quadratic(double begin, double end, double mean);

}  // namespace rubsweep::branch::continuation
