#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::linear {

/// Excitation of a linear run. Its response to all forces that turn with the shaft is Re(A e^{i phi}) with a
/// phasor A that changes with the speed: `in_phase` gives its real part times e^{i phi}, `quarter_behind` the
/// imaginary one, because forces a quarter turn behind give the response of a quarter turn ago.
enum class Driven {
  by_all,          ///< also weight, kick, faulty bearings and forces of twice the shaft's frequency
  in_phase,        ///< unbalance and bow alone
  quarter_behind,  ///< the same, turned back by a quarter turn
};

/// The structure of a machine without its contacts, while the shaft's angle is phi = 2 pi (from t + rate t^2
/// / 2): the preliminary experiments on a rotor. The unbalance forces e Re(U (phi'^2 - i phi'') e^{i phi}), a
/// bow Re(bow e^{i phi}), couplings of unequal stiffness Re(second e^{2 i phi}). The gyroscopic moment and
/// the damping that turns with the shaft follow phi'; the torque that turns a disc acts along the disc's own
/// axis, which leaves no further term of phi'' (angles small). Faulty bearings strike whenever phi says so.
struct LinearRun {
  double from_hz = 0;  ///< >= 0; above 0 the run starts on the quiet motion there, at 0 at rest
  double rate_hz_per_s = 0;
  double eccentricity_m = 0;
  bool kick = false;  ///< the machine's kick at t = 0, towards the first stop's wall unless it has an angle
  Driven driven = Driven::by_all;
  double sample_s = 1e-3;
  int samples = 0;  ///< number of samples, at t = 0, sample_s, ...
};

/// Places to look from: sensors of a rotor kit, each along its angle; else the rotor in x and in y.
struct SensorRows {
  Eigen::MatrixXd rows;           ///< sensors x n: displacement in metres = row * q
  std::vector<double> angle_deg;  ///< direction of each
};
SensorRows sensor_rows(const scene::PreparedMachine& prepared);

/// Displacements seen by the sensors, samples x sensors, in metres. Throws SolverError when the steps
/// collapse.
Eigen::MatrixXd run_linear(const scene::PreparedMachine& prepared, const LinearRun& run,
                           const Eigen::MatrixXd& sensor_rows);

/// Shaft angle in radians and its speed in Hz at time `t_s`.
double shaft_angle_rad(const LinearRun& run, double t_s);
double shaft_speed_hz(const LinearRun& run, double t_s);

}  // namespace rubsweep::linear
