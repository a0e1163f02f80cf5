#pragma once

#include <string>

#include "rubsweep/measurement/fit/machine_fit.hpp"

namespace rubsweep::apps {

/// Texts of the files that describe a fit.
struct FitTables {
  std::string parameters_csv;   ///< parameter, value, standard_error, low_95, high_95, start, at_bound
  std::string correlation_csv;  ///< column parameter, then one column per parameter
  /// Columns data (number of the file), kind, sensor, part (signal, real, imaginary), at (t_s or speed_hz),
  /// measured_m, modelled_m.
  std::string residuals_csv;
  std::string summary;
};

/// `machine`: the machine that was fitted, whose sensors have names.
FitTables tables_of(const fit::MachineFit& problem, const fit::MachineFitResult& result,
                    const model::Machine& machine);

/// A sentence that compares, by Schwarz' criterion, the fit with another fit of the same data that has fewer
/// parameters. `without`: names of the parameters left out.
std::string comparison_text(const fit::MachineFitResult& with, const fit::MachineFitResult& less,
                            const std::string& without);

}  // namespace rubsweep::apps
