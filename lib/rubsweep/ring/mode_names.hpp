#pragma once

#include <string>
#include <vector>

#include "rubsweep/ring/eigenvalues.hpp"

namespace rubsweep::ring {

/// Names of the N modes: the two of the ring, then one for every load with a coordinate, called radial where
/// that coordinate is mostly along the load (inclination above 45 degrees).
std::vector<std::string> mode_names(const System& system);

/// Mode of every eigenvalue at the first speed of a track, by where the coordinates of the loads move most.
/// Either of the two modes that are left to the ring may come first (see name_ring_modes).
std::vector<int> first_modes(const Spectrum& spectrum);

/// Name of an eigenvector by its shape, whatever curve it lies on: the name of the load that holds more of
/// the kinetic energy than the ring, else the direction in which the wave on the ring runs over the ground;
/// "ring" where the root is real.
std::string shape_name(const std::vector<std::string>& names, int nodal_diameters, double speed_rad_per_s,
                       std::complex<double> value, const Eigen::VectorXcd& vector);

/// Makes both eigenvalues of every conjugate pair belong to one mode, each mode having two. A pair made of
/// real roots of two modes keeps one of these, and the two remaining roots take the other.
void pair_up(const Eigen::VectorXcd& values, std::vector<int>& mode);

}  // namespace rubsweep::ring
