#pragma once

#include <string>

#include "rubsweep/measurement/fit/machine_fit.hpp"

namespace rubsweep::fit {

/// A fit as texts.
struct FitTables {
  std::string parameters_csv;   ///< parameter, value, standard_error, low_95, high_95, start, at_bound
  std::string correlation_csv;  ///< parameter, then one column for each parameter
  /// data (number of the file), kind, sensor, part (signal, real, imaginary), at (t_s or speed_hz),
  /// measured_m, modelled_m
  std::string residuals_csv;
  std::string summary;
};

FitTables tables_of(const MachineFit& problem, const MachineFitResult& result);

/// A sentence on the same data fitted with fewer parameters, by Schwarz' criterion. `without`: the names left
/// out.
std::string comparison_text(const MachineFitResult& with, const MachineFitResult& less,
                            const std::string& without);

}  // namespace rubsweep::fit
