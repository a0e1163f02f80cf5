#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rubfit_arguments.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/measurement/fit/machine_fit.hpp"

namespace rubsweep::apps {

/// A problem, and the configuration that it is about.
struct FittedMachine {
  fit::MachineFit problem;
  std::string text;                                     ///< the configuration as it is printed
  std::shared_ptr<const scene::PreparedMachine> first;  ///< machine of that configuration
};

/// The problem that the command line asks for. A key without bounds gets a twentieth and twenty times its
/// value, an angle half a turn to either side, drawn in to what the configuration allows. Throws UsageError
/// for a name that is no number of the configuration and none of rubfit's own, ConfigError as the readers of
/// data do.
FittedMachine fitted_machine_of(const RubfitArguments& arguments, const config::RunConfig& config);

/// Takes the phases of its tables in another meaning than the one that they were read in.
void take_phases_as(fit::PhaseConvention other, fit::PhaseConvention read_as, FittedMachine& fitted);

/// The same with some parameters left as the configuration and the command line have them.
fit::MachineFit without(const FittedMachine& fitted, const std::vector<std::string>& names);

/// The configuration with the values that were found, as YAML.
std::string fitted_config(const FittedMachine& fitted, const Eigen::VectorXd& values);

}  // namespace rubsweep::apps
