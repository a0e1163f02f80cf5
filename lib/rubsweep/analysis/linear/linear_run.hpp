#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::linear {

/// Forces of a linear run. The response to all rotating forces is Re(A e^{i phi}), and the phasor A changes
/// with the speed. Two runs give A. `in_phase` gives the real part of A e^{i phi}; `quarter_behind`, with all
/// forces a quarter turn later, gives its imaginary part.
enum class Driven {
  by_all,          ///< with weight, kick, faulty bearings and forces at twice the shaft's frequency
  in_phase,        ///< only unbalance and bow
  quarter_behind,  ///< only unbalance and bow, a quarter turn later
};

/// Run of a machine's structure without its contacts, for preliminary experiments on a rotor. The shaft angle
/// is phi = 2 pi (from t + rate t^2 / 2). The unbalance forces are e Re(U (phi'^2 - i phi'') e^{i phi}), the
/// forces of a bow Re(bow e^{i phi}), and those of couplings of unequal stiffness Re(second e^{2 i phi}).
/// Gyroscopic moment and rotating damping follow phi'. The torque that accelerates a disc acts along the
/// disc's own axis, so that for small angles there are no further terms with phi''. Impulses of faulty
/// bearings act at fixed angles of the shaft.
struct LinearRun {
  double from_hz = 0;  ///< > 0: starts on the quiet motion of this speed; 0: starts at rest
  double rate_hz_per_s = 0;
  double eccentricity_m = 0;
  /// true: kick at t = 0, in the direction of the first stop's wall unless it has an angle
  bool kick = false;
  Driven driven = Driven::by_all;
  double sample_s = 1e-3;
  int samples = 0;  ///< number of samples, at t = 0, sample_s, ...
};

/// Measured displacements: the sensors of a rotor kit, each along its direction, or for a Jeffcott rotor x
/// and y.
struct SensorRows {
  Eigen::MatrixXd rows;           ///< sensors x n: displacement in metres = row * q
  std::vector<double> angle_deg;  ///< direction of each sensor
};
SensorRows sensor_rows(const scene::PreparedMachine& prepared);

/// Displacements measured by the sensors, samples x sensors, in metres. Throws SolverError where the
/// integration steps become too small.
Eigen::MatrixXd run_linear(const scene::PreparedMachine& prepared, const LinearRun& run,
                           const Eigen::MatrixXd& sensor_rows);

/// Shaft angle in radians and shaft speed in Hz at time `t_s`.
double shaft_angle_rad(const LinearRun& run, double t_s);
double shaft_speed_hz(const LinearRun& run, double t_s);

}  // namespace rubsweep::linear
