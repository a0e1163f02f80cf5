#pragma once

#include <span>

namespace rubsweep::fit {

/// Whether residuals in a row, such as samples in time, are noise.
struct ResidualTest {
  bool white = true;
  double portmanteau =
      0;  ///< Ljung and Box's sum over eight lags; noise stays below 20.09 in 99 of 100 cases
  double first_correlation = 0;  ///< of neighbours, -1..1
  /// Largest line of the periodogram in cycles per residual, and its share of the sum of squares; noise makes
  /// one as large in a smaller share of cases than `level` where `line_stands_out` (Fisher's test).
  double line = 0, line_share = 0;
  bool line_stands_out = false;
};

/// Fewer than 24 residuals are white: nothing can be said. `level`: share of noises that are taken for no
/// noise, by either test.
ResidualTest test_residuals(std::span<const double> residuals, double level = 0.01);

}  // namespace rubsweep::fit
