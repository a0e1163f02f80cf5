#pragma once

#include <string>
#include <vector>

#include "rubfit_arguments.hpp"
#include "rubsweep/config/run_config.hpp"
#include "rubsweep/fit/machine_fit.hpp"

namespace rubsweep::apps {

/// The problem that the command line asks for. A key without bounds gets a twentieth and twenty times its
/// value, an angle half a turn to either side, drawn in to what the configuration allows. Throws UsageError
/// for a name that is no number of the configuration and none of rubfit's own, ConfigError as the readers of
/// data do.
fit::MachineFit machine_fit_of(const RubfitArguments& arguments, const config::RunConfig& config);

/// The same with some parameters left as the configuration and the command line have them.
fit::MachineFit without(const fit::MachineFit& problem, const config::RunConfig& config,
                        const std::vector<std::string>& names);

/// The configuration with the values that were found, as YAML.
std::string fitted_config(const fit::MachineFit& problem, const config::RunConfig& config,
                          const Eigen::VectorXd& values);

}  // namespace rubsweep::apps
