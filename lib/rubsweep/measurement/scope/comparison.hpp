#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

/// A line of a measured motion beside the same line of a simulated one.
struct ComparedLine {
  double order = 0;
  std::complex<double> measured_m = 0, simulated_m = 0;  ///< the simulated one turned to the measured mark
  double difference =
      0;  ///< |measured - simulated| in units of the standard uncertainty of the measured line
};

struct Comparison {
  std::vector<ComparedLine> lines{};                ///< ascending orders
  std::vector<std::complex<double>> simulated_m{};  ///< orbit of the simulated motion, turned likewise
  /// Angle of the shaft from the simulated motion's begin to the mark, in turns: less than its period.
  double turned_by = 0;
  double misfit = 0;  ///< root mean square of the differences, without order 0
  double unexplained =
      0;  ///< share of the measured energy without 0X that the simulated motion leaves, from 0 on
};

/// Lays a simulated motion over a measured one that repeats. `simulated_m`: one period of it, equally spaced
/// over `turns` turns. Where a mark is on the shaft says nothing of where the unbalance is: the angle between
/// both is the one that leaves the smallest sum of squares. Orders up to most_order; a line that one of both
/// motions does not have is compared with 0. Needs noise_m > 0, else differences are in metres over the
/// smallest double above 0.
Comparison compare(const Verdict& measured, std::span<const std::complex<double>> simulated_m, int turns,
                   bool plane);

/// order, measured_m, measured_phase_deg, simulated_m, simulated_phase_deg, difference
std::string comparison_csv(const Comparison& comparison);
/// turns, x_m, y_m of the simulated orbit.
std::string simulated_orbit_csv(const Comparison& comparison, int turns, bool plane);
/// Lines for a terminal: misfit, and the lines that differ most.
std::string comparison_summary(const Comparison& comparison, const model::ShownLengths& shown = {});

}  // namespace rubsweep::scope
