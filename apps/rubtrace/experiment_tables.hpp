#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/linear/experiment.hpp"
#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::apps {

/// Results of an experiment without contact as texts: sensor readings, and parameters identified from them.
struct ExperimentTables {
  std::string sensors_csv;         ///< t_s, speed_hz, shaft_angle_rad, then sensor_i_m
  std::string bode_csv;            ///< run-up only: speed_hz, then sensor_i_amplitude_m, sensor_i_phase_deg
  std::string identification_csv;  ///< quantity, sensor, value
  std::string summary;             ///< text for a terminal
};

/// CSV with t_s, speed_hz, shaft_angle_rad, then sensor_i_m. `signal`: one row per sample, one column per
/// sensor. `derivative`: of each sensor, 1 for sensor_i_m_per_s, 2 for sensor_i_m_per_s2; empty:
/// displacements.
std::string sensors_csv(const linear::LinearRun& run, const Eigen::MatrixXd& signal,
                        const std::vector<int>& derivative = {});

ExperimentTables tables_of(const linear::FreeResponse& response, const model::Machine& machine);
/// Tables and summary of a run-up. `shown`: unit of amplitudes in the summary, m by default.
ExperimentTables tables_of(const linear::RunUp& run_up, const model::Machine& machine,
                           const model::ShownLengths& shown = {});

}  // namespace rubsweep::apps
