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

/// Numbers beside the keys of a configuration that may be looked for.
inline constexpr const char* eccentricity_name = "eccentricity_m";  ///< eccentricity in run-ups and steady 1X
inline constexpr const char* mark_name =
    "mark_deg";  ///< angle of the configuration's mark when the measured one passes
inline constexpr const char* hit_name = "hit_s";  ///< instant of the ring-downs at which the kick began
inline constexpr const char* rate_name = "rate_hz_per_s";  ///< rate of run-ups, in place of the measured one

struct MachineFit {
  std::vector<Parameter> parameters;  ///< keys of the configuration, or names from above
  std::vector<MeasuredData> data;
  double eccentricity_m = 0, mark_deg = 0, hit_s = 0;  ///< values of names that are no parameters
  /// Machine with these values of the parameters that are keys (in their order), else the names from above
  /// are skipped. Throws ConfigError for values that are not allowed.
  std::function<scene::PreparedMachine(const Eigen::VectorXd&)> machine;
  /// Lines of these orders that a machine with an eccentricity in metres has while it rubs, phi = 0 where its
  /// mark points along +x; needed with RubLines. Throws as `machine` does.
  std::function<Eigen::VectorXcd(const scene::PreparedMachine&, const RubLines&, double)> rub_lines{};
  /// Told of the machines that the fit passes through, one after the other, from which others are found; may
  /// be left out.
  std::function<void(const scene::PreparedMachine&, const RubLines&, double)> follow_rub{};
};

/// Value of the parameter of that name; `otherwise` where it is none.
double value_named(const MachineFit& problem, const Eigen::VectorXd& values, const char* name,
                   double otherwise);

/// The machine of a fit at one step, as scene::prepare_machine makes it, but a rotor kit is reduced to as
/// many modes as `first`, the machine at which the fit began: a number that jumps has no derivative. Throws
/// ConfigError as prepare_machine does.
scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first);

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
