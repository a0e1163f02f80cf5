#pragma once

#include <span>
#include <string>
#include <vector>

#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

/// The eigenvalues at one speed, each with the mode it belongs to. A mode has two: a conjugate pair, or two
/// real ones.
struct TrackPoint {
  double speed_rad_per_s = 0;
  bool asked = true;  ///< false: put in by the tracker, to tell the modes apart
  Spectrum spectrum;
  std::vector<int> mode;  ///< mode of every eigenvalue; index into Track::names
};

/// Modes followed over the speed.
struct Track {
  int nodal_diameters = 2;
  std::vector<std::string> names;  ///< ring forward, ring backward, load j flexural or radial, j from 0
  std::vector<TrackPoint> points;  ///< ascending speed
};

/// Follows every eigenvalue over `speeds_rad_per_s` (ascending): predicted by its derivative, assigned by
/// distance and modal assurance criterion; where two assignments are about as good the step is halved. Where
/// two real roots of different modes become a pair, that pair takes one of the modes and what is left of both
/// takes the other. Of the ring's two modes the slower one is called forward, at the first speed that tells
/// them apart: in the rotating frame a forward wave has the frequency n |Omega_c - Omega|, a backward one n
/// (Omega_c + Omega).
Track track_modes(const System& system, const NormalForm& form, std::span<const double> speeds_rad_per_s);

/// Name of the curve that eigenvalue `index` of a point lies on, and of its shape there where that
/// differs (two modes exchange their shapes where their curves veer): "ring backward (moves as load 0
/// flexural)".
std::string describe_mode(const Track& track, const TrackPoint& point, std::size_t index);

/// The same for the eigenvalue nearest to `value` at the tracked speed nearest to `speed_rad_per_s`.
std::string describe_mode_near(const Track& track, double speed_rad_per_s, std::complex<double> value);

}  // namespace rubsweep::ring
