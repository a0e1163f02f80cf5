#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "rubsweep/fit/ramp.hpp"

namespace rubsweep::fit {

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
