#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::fit {

/// Displacements in metres after the machine's kick at standstill, without its stops and static loads, in
/// closed form: one row for each instant since the begin of the kick (0 before it), one column for each row
/// of `rows` (displacement = row * q). Throws ConfigError for a machine without a kick.
Eigen::MatrixXd free_vibration(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                               const std::vector<double>& since_s);

}  // namespace rubsweep::fit
