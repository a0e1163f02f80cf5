#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::apps {

/// A line of a measured motion and the corresponding line of a simulated one.
struct ComparedLine {
  double order = 0;
  std::complex<double> measured_m = 0, simulated_m = 0;  ///< the simulated line has the measured mark
  double difference = 0;  ///< |measured - simulated| / standard uncertainty of the measured line
};

struct Comparison {
  std::vector<ComparedLine> lines{};                ///< ascending orders
  std::vector<std::complex<double>> simulated_m{};  ///< orbit of the simulated motion, rotated likewise
  /// Shaft angle between the beginning of the simulated motion and the mark, in turns; less than one period.
  double turned_by = 0;
  double misfit = 0;       ///< root mean square of the differences without order 0
  double unexplained = 0;  ///< residual energy / measured energy, both without 0X
};

/// Compares a simulated motion with a measured one that repeats. `simulated_m`: one period, equally spaced
/// over `turns` turns. The mark does not show where the unbalance is. The angle between both motions is
/// therefore the one with the smallest sum of squares. Orders up to most_order are used; a line that is
/// missing in one motion is compared with 0. Needs noise_m > 0; with 0, differences are divided by the
/// smallest positive double instead.
Comparison compare(const scope::Verdict& measured, std::span<const std::complex<double>> simulated_m,
                   int turns, bool plane);

/// CSV with order, measured_m, measured_phase_deg, simulated_m, simulated_phase_deg, difference.
std::string comparison_csv(const Comparison& comparison);
/// CSV with turns, x_m, y_m of the simulated orbit.
std::string simulated_orbit_csv(const Comparison& comparison, int turns, bool plane);
/// Text for a terminal: the misfit, and the lines that differ most.
std::string comparison_summary(const Comparison& comparison, const model::ShownLengths& shown = {});

}  // namespace rubsweep::apps
