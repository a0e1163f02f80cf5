#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/numerics/pchip.hpp"

namespace rubsweep::structure {

/// Coefficients between the displacement (x, y) of a support and the force on it.
struct SupportMatrices {
  Eigen::Matrix2d stiffness, damping;
  Eigen::Vector2d mass;  ///< masses in x and y
};

/// Coefficients of a support over the speed.
using SupportCurves = std::array<numerics::Pchip, model::support_coefficients.size()>;
SupportCurves curves_of(const model::SupportTable& table);

/// A support whose coefficients follow the speed, as a system in reduced coordinates q has it.
struct TabledSupport {
  Eigen::Matrix<double, 2, Eigen::Dynamic> map;  ///< 2 x n: displacement against what it stands on = map * q
  SupportCurves curves;
  SupportMatrices built_in;  ///< matrices that the system holds already

  /// Parts that the matrices lack at a speed of the table: added are map^T stiffness map and so on. Never
  /// allocates.
  SupportMatrices lacking(double speed_rad_per_s) const;
};

/// A support that has a table, its map still empty.
TabledSupport tabled_support(const model::Support& support);

/// Adds to the matrices of a system what they lack at a speed.
void add_lacking(const TabledSupport& support, double speed_rad_per_s, Eigen::MatrixXd& mass,
                 Eigen::MatrixXd& damping, Eigen::MatrixXd& stiffness);

/// The support at one speed, its table replaced by the numbers. Throws ConfigError, with `path` before its
/// message, for a speed that the table does not reach.
model::Support support_at(const model::Support& support, double speed_hz, const std::string& path);

/// The machine with all supports at one speed: the same numbers as if they had been typed in. Throws as
/// support_at.
model::Machine machine_at(const model::Machine& machine, double speed_hz);

/// Throws ConfigError where a table of the machine does not reach a speed from `low_hz` to `high_hz`.
void refuse_beyond_tables(const model::Machine& machine, double low_hz, double high_hz);

/// Throws ConfigError where the mass of some support changes with the speed, which `what` cannot follow.
void refuse_changing_mass(const model::Machine& machine, const std::string& what);

}  // namespace rubsweep::structure
