#pragma once

#include "rubsweep/model/machine.hpp"

namespace rubsweep::design {

/// Largest vibration of the shaft at a probe that API 617 (9th edition) allows, in metres peak to peak:
/// min(25.4, 25.4 sqrt(12000 / N)) micrometres. N in rpm is the maximum continuous speed, here in Hz, > 0.
double vibration_limit_m(double max_continuous_hz);

/// Eccentricity of a cell that stands for the unbalance of an analysis by API 617, in metres: four times the
/// largest residual unbalance 6350 W / N in g mm, with W in kg the mass of the rotor and N in rpm its maximum
/// continuous speed. The unbalance is spread over the discs as the machine has it. Throws ConfigError where
/// no disc stands off the axis.
double analysis_eccentricity_m(const model::Machine& machine, double max_continuous_hz);

/// Factor from the response that was computed to the one that clearances must bear (API 617, 9th edition; API
/// RP 684): limit / response at the probe that moves most within the operating range, at least 1/2 (as ROSS takes
/// these clauses: a rotor that moves more than twice as much as it may is not judged by less than half of its
/// unbalance) and at most 6. Both in metres peak to peak, `response_m` >= 0.
double scale_factor(double limit_m, double response_m);
inline constexpr double smallest_scale_factor = 0.5, largest_scale_factor = 6;

}  // namespace rubsweep::design
