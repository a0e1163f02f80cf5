#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "rubsweep/fit/last_ramps.hpp"

namespace rubsweep::fit {

/// Numbers of a file: readings, or real and imaginary parts, in the order of the residuals.
Eigen::VectorXd measured_of(const MeasuredData& data);

/// The same numbers of a machine with these values of the parameters, of which it was made. Throws
/// ConfigError for data of more sensors than it has.
Eigen::VectorXd modelled_of(const MachineFit& problem, const MeasuredData& data,
                            const scene::PreparedMachine& machine, const Eigen::VectorXd& values,
                            LastRamps& ramps);

/// Offsets and scales of a file that are fitted with every step.
int eliminated_of(const MeasuredData& data);

/// Model beside the data: real parts, and imaginary ones of 1X, in metres, in the order of the residuals.
struct ModelledData {
  Eigen::VectorXd measured_m, modelled_m;
};
ModelledData modelled(const MachineFit& problem, std::size_t data, const Eigen::VectorXd& values);

/// Root mean squares of what is left of a file, and of its numbers without the offsets that are fitted.
struct WhatIsLeft {
  double left_m = 0, size_m = 0;
  double share() const { return size_m > 0 ? left_m / size_m : 0; }
};
WhatIsLeft what_is_left(const MachineFit& problem, std::size_t data, const Eigen::VectorXd& values);

}  // namespace rubsweep::fit
