#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose {

/// Parameters that rubfit found, with their uncertainty.
struct FittedParameters {
  std::vector<std::string> name{};
  Eigen::VectorXd value{}, low_95{}, high_95{};
  Eigen::MatrixXd error_root{};  ///< R, where R R^T is the correlation of the errors
  std::string text{};            ///< bytes of the files
};

/// Reads parameters.csv and correlation.csv of a directory; without correlation.csv the errors are
/// uncorrelated. Empty where there is no parameters.csv. Throws IoError where a file is damaged.
std::optional<FittedParameters> read_fitted_parameters(const std::filesystem::path& directory);

/// 95 % interval of a parameter; empty where it was not fitted.
std::optional<Spread> interval_of(const FittedParameters& fitted, std::string_view name);

/// Draws parameter values from the normal distribution with the fit's standard errors and correlation. A
/// value without a finite interval keeps its fitted value.
Eigen::VectorXd draw_parameters(const FittedParameters& fitted, RandomStream& random);

}  // namespace rubsweep::diagnose
