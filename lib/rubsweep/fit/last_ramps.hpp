#pragma once

#include <Eigen/Core>
#include <functional>
#include <mutex>

#include "rubsweep/fit/fit_problem.hpp"
#include "rubsweep/fit/ramp_phasor.hpp"
#include "rubsweep/numerics/recently_used.hpp"

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

}  // namespace rubsweep::fit
