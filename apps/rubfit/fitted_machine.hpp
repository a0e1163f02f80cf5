#pragma once

#include <memory>
#include <string>
#include <vector>

#include "rubfit_arguments.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/measurement/fit/machine_fit.hpp"

namespace rubsweep::apps {

/// A fit problem and the configuration that it changes.
struct FittedMachine {
  fit::MachineFit problem;
  std::string text;                                     ///< the configuration in printed form
  std::shared_ptr<const scene::PreparedMachine> first;  ///< machine of the unchanged configuration
};

/// The fit problem of the command line. A key without bounds gets 1/20 and 20 times its value as bounds, and
/// an angle half a turn on either side; these bounds are narrowed to what the configuration allows. Throws
/// UsageError for a name that is neither a number of the configuration nor a special name of rubfit,
/// ConfigError like the readers of data.
FittedMachine fitted_machine_of(const RubfitArguments& arguments, const config::RunConfig& config);

/// Converts the phases of tables from the convention in which they were read to another convention.
void take_phases_as(fit::PhaseConvention other, fit::PhaseConvention read_as, FittedMachine& fitted);

/// The same problem with some parameters fixed at their values from the configuration and the command line.
fit::MachineFit without(const FittedMachine& fitted, const std::vector<std::string>& names);

/// The configuration with the fitted values, as YAML.
std::string fitted_config(const FittedMachine& fitted, const Eigen::VectorXd& values);

}  // namespace rubsweep::apps
