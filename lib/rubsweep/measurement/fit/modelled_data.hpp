#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "rubsweep/core/numerics/recently_used.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/fit/fit_problem.hpp"
#include "rubsweep/measurement/fit/ramp_phasor.hpp"

namespace rubsweep::fit {

/// Ramps that were computed last: those along an eccentricity or an angle of the mark differ by a factor. For
/// several threads.
class LastRamps {
 public:
  explicit LastRamps(const MachineFit& problem) : known_(4 * problem.data.size()) {}

  /// `values` of the problem's parameters; `make` computes what is not there.
  RampParts of(const MachineFit& problem, const RunUp& run, Eigen::VectorXd values,
               const std::function<RampParts()>& make);

 private:
  struct Known {
    const RunUp* run;
    Eigen::VectorXd values;
    RampParts parts;
  };
  std::mutex mutex_;
  numerics::RecentlyUsed<Known> known_;
};

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

/// Displacements in metres after the machine's kick at standstill, without its stops and static loads, in
/// closed form: one row for each instant since the begin of the kick (0 before it), one column for each row
/// of `rows` (displacement = row * q). Throws ConfigError for a machine without a kick.
Eigen::MatrixXd free_vibration(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                               const std::vector<double>& since_s);

}  // namespace rubsweep::fit
