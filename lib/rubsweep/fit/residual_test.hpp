#pragma once

#include <span>
#include <string>
#include <vector>

namespace rubsweep::fit {

/// Whether residuals in a row, such as samples in time, are noise.
struct ResidualTest {
  bool white = true;
  double portmanteau =
      0;  ///< Ljung and Box's sum over eight lags; noise stays below 20.09 in 99 of 100 cases
  double first_correlation = 0;  ///< of neighbours, -1..1
  /// Largest line of the periodogram in cycles per residual, and its share of the sum of squares; noise makes
  /// one as large in fewer than one of 100 cases where `line_stands_out` (Fisher's test).
  double line = 0, line_share = 0;
  bool line_stands_out = false;
};

/// Fewer than 24 residuals are white: nothing can be said.
ResidualTest test_residuals(std::span<const double> residuals);

}  // namespace rubsweep::fit
