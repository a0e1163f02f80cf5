#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <complex>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/fit/measured_data.hpp"

namespace rubsweep::fit {

/// Modes of a machine without its contacts at one shaft speed. The state (q, q') is vectors * a, with a' =
/// values a + force(f) for a generalised force f in newtons.
struct ModeSet {
  Eigen::VectorXcd values;                       ///< 2 n eigenvalues in 1/s
  Eigen::MatrixXcd vectors;                      ///< 2 n x 2 n
  Eigen::PartialPivLU<Eigen::MatrixXcd> factor;  ///< LU factors of the matrix of eigenvectors
  Eigen::MatrixXd inverse_mass;                  ///< n x n

  Eigen::VectorXcd force(const Eigen::VectorXcd& newtons) const;
};

/// Modes with the gyroscopic moments and the rotating damping at this speed. Throws SolverError where the
/// iteration does not converge or the modes do not span the state space.
ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s);

/// 1X of a machine without its stops while its speed changes: A of the displacement Re(A e^{i phi}) due to
/// unbalance and bow. One row per ascending instant, one column per row of `rows` (displacement = row * q).
/// Every value is a mean over `window_turns` turns about its instant, weighted by the shaft angle; with 0 it
/// is no mean. Modes near a resonance are integrated by Gauss-Legendre quadrature; modes far from any
/// resonance follow the speed to second order. Modes that depend on the speed are constant on stretches of
/// 0.25 Hz. The stretches are wider where there would be more than 64 (128 with tables). The motion before
/// the first instant is assumed to be free of resonances. Throws ConfigError for a speed that is not above 0.
Eigen::MatrixXcd ramp_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                              double eccentricity_m, const Ramp& ramp, const std::vector<double>& t_s,
                              double window_turns);

/// The phasors of ramp_phasors in two parts, for several eccentricities: the result is eccentricity times the
/// first part, plus the second part.
struct RampParts {
  Eigen::MatrixXcd per_eccentricity;  ///< response in metres per metre
  Eigen::MatrixXcd bow_m;
  /// Mean of conj(A) e^{-2i phi} of each part, over a window of whole turns that begins at a multiple of half
  /// a turn. A sensor's 1X is computed as the mean of 2 Re(A e^{i phi}) e^{-i phi}, which is the mean of A
  /// plus this term. The term vanishes only where A is constant.
  Eigen::MatrixXcd per_eccentricity_mirrored, bow_mirrored_m;
};
RampParts ramp_parts(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows, const Ramp& ramp,
                     const std::vector<double>& t_s, double window_turns);

/// Phasors at a steady speed, in closed form: one column per row of `rows`.
Eigen::RowVectorXcd steady_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                                   double eccentricity_m, double speed_hz);

/// One instant of an averaging window over some turns of a ramp, and its weights in the means of A and of
/// conj(A) e^{-2i phi}, phi = 0 in the middle.
struct WindowNode {
  double t_s = 0, weight = 0;
  std::complex<double> mirrored;
  Eigen::Index point = 0;  ///< row of the instant to which the window belongs
};

/// Nodes of the windows about all instants, the earliest first. Each window has five nodes at equal distances
/// in the shaft angle, weighted by the polynomial of fourth degree through them. A window of 0 turns has one
/// node. Throws ConfigError for a speed that is not above 0.
std::vector<WindowNode> window_nodes(const Ramp& ramp, const std::vector<double>& t_s, double window_turns);

}  // namespace rubsweep::fit
