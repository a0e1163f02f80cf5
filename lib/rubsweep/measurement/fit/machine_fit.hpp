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
  int begin = 0, count = 0;  ///< place among all residuals
  int eliminated = 0;        ///< offsets and scales that were fitted with every step
  double noise_m = 0;        ///< root mean square of its residuals, by which they were divided
};

struct MachineFitResult {
  LeastSquaresFit fit;
  Uncertainty uncertainty;
  std::vector<DataResidual> data;
  double bic = 0;  ///< Schwarz' criterion, up to a constant of the data
};

/// Fits the parameters to all data together. Data of different files count by their own noise, which is
/// estimated from a first fit. Offsets of ring-downs, their common scale (nobody knows how hard it was
/// struck), and run-out where asked for, are eliminated at every step. Throws ConfigError for data that the
/// machine, or the parameters, do not go with, and for first values that are not allowed. Stopped before
/// anything was found, it has no value.
MachineFitResult fit_machine(const MachineFit& problem, const LeastSquaresOptions& options);

}  // namespace rubsweep::fit
