#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/fit/least_squares.hpp"
#include "rubsweep/measurement/fit/measured_data.hpp"

namespace rubsweep::fit {

/// Numbers beside the keys of a configuration that may be looked for.
inline constexpr const char* eccentricity_name = "eccentricity_m";  ///< of the run-ups and steady 1X
inline constexpr const char* mark_name =
    "mark_deg";  ///< angle of the configuration's mark when the measured one passes
inline constexpr const char* hit_name = "hit_s";  ///< instant of the ring-downs at which the kick began
inline constexpr const char* rate_name = "rate_hz_per_s";  ///< of run-ups, in place of the measured one

struct MachineFit {
  std::vector<Parameter> parameters;  ///< keys of the configuration, or names from above
  std::vector<MeasuredData> data;
  double eccentricity_m = 0, mark_deg = 0, hit_s = 0;  ///< where they are no parameters
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

}  // namespace rubsweep::fit
