#pragma once

namespace rubsweep::numerics {

/// Largest value over one step of the cubic with the given end values and end slopes per step.
double cubic_maximum(double start, double start_slope, double end, double end_slope);

}  // namespace rubsweep::numerics
