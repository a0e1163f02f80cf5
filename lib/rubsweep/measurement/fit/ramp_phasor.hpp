#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <complex>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/fit/measured_data.hpp"

namespace rubsweep::fit {

/// Vibration modes of a machine without its contacts at one shaft speed: the state (q, q') is vectors * a,
/// with a' = values a + force(f) for a generalised force f in newtons.
struct ModeSet {
  Eigen::VectorXcd values;                       ///< 2 n eigenvalues in 1/s
  Eigen::MatrixXcd vectors;                      ///< 2 n x 2 n
  Eigen::PartialPivLU<Eigen::MatrixXcd> factor;  ///< factors of the matrix of eigenvectors
  Eigen::MatrixXd inverse_mass;                  ///< n x n

  Eigen::VectorXcd force(const Eigen::VectorXcd& newtons) const;
};

/// With gyroscopic moments and rotating damping of this speed. Throws SolverError where the iteration does
/// not converge or the modes do not span the motion.
ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s);

/// 1X of a machine without its stops while its shaft speed changes: A of the displacement Re(A e^{i
/// phi}) that unbalance and bow make, at ascending instants, one row each, one column for each row of `rows`
/// (displacement = row * q). Every value is the mean over `window_turns` turns about its instant, as 1X of a
/// recording is, weighed by the shaft's angle; 0: none. Each mode near a resonance is integrated by Gauss and
/// Legendre's rule; one far from any follows the speed by its answer to second order. Modes that change with
/// the speed are those of the middle of stretches in which it changes by 0.25 Hz, or more where that makes
/// more than 64 of them, with tables 128. Before the first instant the speed is taken to have been passed
/// without a resonance. Throws ConfigError for a speed that is not above 0.
Eigen::MatrixXcd ramp_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                              double eccentricity_m, const Ramp& ramp, const std::vector<double>& t_s,
                              double window_turns);

/// The same in parts, eccentricity times the first and the second, for what asks for several eccentricities.
struct RampParts {
  Eigen::MatrixXcd per_eccentricity;  ///< response in metres per metre
  Eigen::MatrixXcd bow_m;
  /// Means of conj(A) e^{-2i phi}, of each, over a window of whole turns that begins where phi is a multiple
  /// of half a turn. The mean of 2 Re(A e^{i phi}) e^{-i phi}, by which a sensor's 1X is found, has it beside
  /// that of A: where A changes it does not vanish.
  Eigen::MatrixXcd per_eccentricity_mirrored, bow_mirrored_m;
};
RampParts ramp_parts(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows, const Ramp& ramp,
                     const std::vector<double>& t_s, double window_turns);

/// The same at a steady speed, in closed form.
Eigen::RowVectorXcd steady_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                                   double eccentricity_m, double speed_hz);

/// An instant of a window over some turns of a ramp, at which 1X is asked for, and its weights in the means
/// over the window of A and of conj(A) e^{-2i phi}, phi = 0 in the middle.
struct WindowNode {
  double t_s = 0, weight = 0;
  std::complex<double> mirrored;
  Eigen::Index point = 0;  ///< row of the window's own instant
};

/// Nodes of the windows of so many turns about all instants, earliest first: five each, equally far apart in
/// the shaft's angle, whose weights are those of the polynomial of fourth degree through them; one alone for
/// no turns. Throws ConfigError for a speed that is not above 0.
std::vector<WindowNode> window_nodes(const Ramp& ramp, const std::vector<double>& t_s, double window_turns);

}  // namespace rubsweep::fit
