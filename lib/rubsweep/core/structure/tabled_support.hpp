#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/numerics/pchip.hpp"

namespace rubsweep::structure {

/// Coefficients between the displacement (x, y) of a support and its force.
struct SupportMatrices {
  Eigen::Matrix2d stiffness, damping;
  Eigen::Vector2d mass;  ///< masses in x and y
};

/// Coefficients of a support over the speed.
using SupportCurves = std::array<numerics::Pchip, model::support_coefficients.size()>;
SupportCurves curves_of(const model::SupportTable& table);

/// A support whose coefficients depend on the speed, in the reduced coordinates q of a system.
struct TabledSupport {
  Eigen::Matrix<double, 2, Eigen::Dynamic> map;  ///< 2 x n: displacement relative to its base = map * q
  SupportCurves curves;
  SupportMatrices built_in;  ///< coefficients that the system's matrices already include

  /// Coefficients that the system's matrices lack at a speed of the table; the missing stiffness is map^T
  /// stiffness map, and so on. Never allocates memory.
  SupportMatrices lacking(double speed_rad_per_s) const;
};

TabledSupport tabled_support(const model::Support& support);  ///< Support with a table and an empty map.

/// Adds to the matrices of a system the part of a support that they lack at a speed.
void add_lacking(const TabledSupport& support, double speed_rad_per_s, Eigen::MatrixXd& mass,
                 Eigen::MatrixXd& damping, Eigen::MatrixXd& stiffness);

/// The support at one speed, with numbers in place of its table. Throws ConfigError, with `path` before the
/// message, for a speed outside the table.
model::Support support_at(const model::Support& support, double speed_hz, const std::string& path);

/// The machine at one speed, as if the coefficients of its supports there had been entered as constants.
/// Throws as support_at.
model::Machine machine_at(const model::Machine& machine, double speed_hz);

/// Throws ConfigError where a table of the machine does not reach a speed from `low_hz` to `high_hz`.
void refuse_beyond_tables(const model::Machine& machine, double low_hz, double high_hz);

/// Throws ConfigError where some support's mass changes with the speed, which `what` cannot handle.
void refuse_changing_mass(const model::Machine& machine, const std::string& what);

}  // namespace rubsweep::structure
