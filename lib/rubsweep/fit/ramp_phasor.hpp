#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::fit {

/// Shaft angle phi = 2 pi (from_hz t + rate_hz_per_s t^2 / 2).
struct Ramp {
  double from_hz = 0;
  double rate_hz_per_s = 0;
};

/// 1X of a machine without its stops while its shaft speed changes evenly: A of the displacement Re(A e^{i
/// phi}) that unbalance and bow make, at ascending instants, one row each, one column for each row of `rows`
/// (displacement = row * q). Every value is the mean over `window_turns` turns about its instant, as 1X of a
/// recording is; 0: none. Each mode near a resonance is integrated by Gauss and Legendre's rule; one far from
/// any follows the speed by its answer to second order. The modes are those of up to 64 speeds. Before the
/// first instant the speed is taken to have been passed without a resonance. Throws ConfigError for a speed
/// that is not above 0.
Eigen::MatrixXcd ramp_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                              double eccentricity_m, const Ramp& ramp, const std::vector<double>& t_s,
                              double window_turns);

/// The same at a steady speed, in closed form.
Eigen::RowVectorXcd steady_phasors(const scene::PreparedMachine& prepared, const Eigen::MatrixXd& rows,
                                   double eccentricity_m, double speed_hz);

}  // namespace rubsweep::fit
