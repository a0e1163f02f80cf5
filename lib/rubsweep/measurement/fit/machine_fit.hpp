#pragma once

#include <string>
#include <vector>

#include "rubsweep/measurement/fit/least_squares.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"
#include "rubsweep/measurement/fit/uncertainty.hpp"

namespace rubsweep::fit {

/// Residuals of one file of data.
struct DataResidual {
  std::string name;
  int begin = 0, count = 0;  ///< position among all residuals
  int eliminated = 0;        ///< number of offsets and scales that were eliminated at every step
  double noise_m = 0;  ///< root mean square of the file's residuals before their division by this number
};

struct MachineFitResult {
  LeastSquaresFit fit;
  Uncertainty uncertainty;
  std::vector<DataResidual> data;
  double bic = 0;  ///< Schwarz' criterion, up to a constant that depends on the data alone
};

/// Fits the parameters to all data together. Each file is weighted by its own noise, which is estimated from
/// a first fit. Three kinds of numbers are eliminated at every step: offsets of ring-downs, their common
/// scale (the strength of the hit is unknown), and run-out if requested. Throws ConfigError for data that do
/// not suit the machine or the parameters, and for forbidden first values. The result has no values if the
/// fit was stopped before it found any.
MachineFitResult fit_machine(const MachineFit& problem, const LeastSquaresOptions& options);

}  // namespace rubsweep::fit
