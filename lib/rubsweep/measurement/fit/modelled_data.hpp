#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/fit/least_squares.hpp"
#include "rubsweep/measurement/fit/measured_data.hpp"
#include "rubsweep/measurement/fit/ramp_phasor.hpp"

namespace rubsweep::fit {

/// Names of parameters that are not keys of the configuration.
inline constexpr const char* eccentricity_name = "eccentricity_m";  ///< eccentricity in run-ups and steady 1X
inline constexpr const char* mark_name =
    "mark_deg";  ///< angle of the configuration's mark when the measured mark passes
inline constexpr const char* hit_name = "hit_s";  ///< instant at which the kick of the ring-downs began
inline constexpr const char* rate_name = "rate_hz_per_s";  ///< rate of run-ups, in place of the measured one

struct MachineFit {
  std::vector<Parameter> parameters;  ///< keys of the configuration, or names from above
  std::vector<MeasuredData> data;
  double eccentricity_m = 0, mark_deg = 0, hit_s = 0;  ///< values of the names above that are not parameters
  /// Machine for these values of the parameters that are keys of the configuration, in their order (other
  /// parameters have no value here). Throws ConfigError for forbidden values.
  std::function<scene::PreparedMachine(const Eigen::VectorXd&)> machine;
  /// Spectral lines of the requested orders for a machine that rubs, with an eccentricity in metres; phi = 0
  /// where its mark points along +x. Needed with RubLines. Throws like `machine`.
  std::function<Eigen::VectorXcd(const scene::PreparedMachine&, const RubLines&, double)> rub_lines{};
  /// Called with each machine that the fit passes through; the search for rubs of later machines starts from
  /// the rubs of this one. May be empty.
  std::function<void(const scene::PreparedMachine&, const RubLines&, double)> follow_rub{};
};

/// Value of the parameter with this name; `otherwise` where there is none.
double value_named(const MachineFit& problem, const Eigen::VectorXd& values, const char* name,
                   double otherwise);

/// Prepares the machine of one step of the fit like scene::prepare_machine, but reduces a rotor kit to as
/// many modes as `first`, the machine at the start. A change of the number of modes would make the residuals
/// discontinuous. Throws ConfigError like prepare_machine.
scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first);

/// Recently computed ramps. Ramps that differ only in eccentricity or mark angle are proportional, so they
/// share one entry. Several threads may use it.
class LastRamps {
 public:
  explicit LastRamps(const MachineFit& problem) : known_(4 * problem.data.size()) {}

  /// Ramp for these `values` of the problem's parameters; calls `make` where it is not stored.
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

/// Measured numbers of a file in the order of the residuals: readings, or real and imaginary parts.
Eigen::VectorXd measured_of(const MeasuredData& data);

/// Numbers of the model that correspond to measured_of; `machine` was made from `values`. Throws ConfigError
/// where the data have more sensors than the machine.
Eigen::VectorXd modelled_of(const MachineFit& problem, const MeasuredData& data,
                            const scene::PreparedMachine& machine, const Eigen::VectorXd& values,
                            LastRamps& ramps);

/// Number of a file's offsets and scales that are eliminated at every step.
int eliminated_of(const MeasuredData& data);

/// Measured and modelled numbers in metres, in the order of the residuals: real parts, and imaginary ones for
/// 1X.
struct ModelledData {
  Eigen::VectorXd measured_m, modelled_m;
};
ModelledData modelled(const MachineFit& problem, std::size_t data, const Eigen::VectorXd& values);

/// Root mean squares of a file's residuals, and of its numbers without the eliminated offsets.
struct WhatIsLeft {
  double left_m = 0, size_m = 0;
  double share() const { return size_m > 0 ? left_m / size_m : 0; }
};
WhatIsLeft what_is_left(const MachineFit& problem, std::size_t data, const Eigen::VectorXd& values);

/// Displacements in metres after the machine's kick at standstill, in closed form, without stops and static
/// loads. One row per instant, counted from the beginning of the kick (0 before it); one column per row of
/// `rows` (displacement = row * q). Throws ConfigError for a machine without a kick.
Eigen::MatrixXd free_vibration(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                               const std::vector<double>& since_s);

}  // namespace rubsweep::fit
