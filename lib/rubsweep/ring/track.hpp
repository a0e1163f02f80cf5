#pragma once

#include <span>
#include <string>
#include <vector>

#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

/// Eigenvalues at one speed with their modes. Each mode has two eigenvalues: a conjugate pair, or two real
/// ones.
struct TrackPoint {
  double speed_rad_per_s = 0;
  bool asked = true;  ///< false: added by the tracker to distinguish the modes
  Spectrum spectrum;
  std::vector<int> mode;  ///< mode of every eigenvalue; index into Track::names
};

/// Modes followed over the speed.
struct Track {
  int nodal_diameters = 2;
  std::vector<std::string> names;  ///< ring forward, ring backward, load j flexural or radial, j from 0
  std::vector<TrackPoint> points;  ///< ascending speed
};

/// Follows every eigenvalue over `speeds_rad_per_s` (ascending). Eigenvalues are predicted by their
/// derivatives and assigned by distance and modal assurance criterion. If two assignments are about equally
/// good, the step is halved. If real roots of two modes become a pair, the pair gets one of the modes, and
/// the remaining roots get the other. Of the ring's two modes, the slower one at the first speed that
/// distinguishes them is called forward: in the rotating frame a forward wave has the frequency n |Omega_c -
/// Omega|, a backward wave n (Omega_c + Omega).
Track track_modes(const System& system, const NormalForm& form, std::span<const double> speeds_rad_per_s);

/// Name of the curve of eigenvalue `index` at a point. If its shape there is that of another mode, as after a
/// veering of two curves, the name of this shape is added: "ring backward (moves as load 0 flexural)".
std::string describe_mode(const Track& track, const TrackPoint& point, std::size_t index);

/// Name, as by describe_mode(), for the eigenvalue nearest to `value` at the tracked speed nearest to
/// `speed_rad_per_s`.
std::string describe_mode_near(const Track& track, double speed_rad_per_s, std::complex<double> value);

}  // namespace rubsweep::ring
