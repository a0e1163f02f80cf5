#pragma once

#include <Eigen/Core>

#include "rubsweep/measurement/diagnose/features/line_features.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::features {

/// Direction in which a motion of two probes is lopsided: the angle of the mean of |z|^2 z, rad from +x to
/// +y. A flat stop cuts the orbit off, so the lopsided direction points away from it.
double lopsided_direction(const Eigen::VectorXcd& waveform);

/// Features of the orbit: how round, lopsided and three-cornered it is, its extent along and across the
/// lopsided direction, its radii and its whirl. `waveform`: x + iy about the mean, equidistant samples over
/// whole turns.
Features orbit_features(const Eigen::VectorXcd& waveform);

/// Features of the signal of a single probe: its moments and its extent.
Features signal_features(const Eigen::VectorXd& waveform);

/// Phases of the lines relative to each other as points inside the unit circle; the points of weak lines lie
/// near the centre. `plane`: two probes; else the motion is real.
Features phase_features(const MotionLines& lines, bool plane);

/// A motion described for comparisons: features that depend on neither its size nor its direction, and beside
/// them its size and direction.
struct DescribedMotion {
  Features features{};
  double size_m = 0;         ///< root mean square about the mean
  double direction_rad = 0;  ///< lopsided_direction, rad; 0 for one probe
};

/// Parts of a recording that can be interpreted.
struct View {
  bool plane = true;        ///< two probes; else one, and only lines from order 0 on count
  bool directions = false;  ///< the machine is anisotropic, so directions carry information
  bool from_rest = false;   ///< readings count from the rest position, so their mean carries information
};

/// Features of the lines and of the orbit. `view.directions` adds the directions, from +x, of the longest and
/// the lopsided axis; `view.from_rest` adds the mean position in units of the motion's size.
DescribedMotion describe(const MotionLines& lines, const View& view,
                         response::spectrum::SpectrumWorkspace& workspace);

/// Values of the features as a vector, in the same order.
Eigen::VectorXd values_of(const Features& features);

}  // namespace rubsweep::diagnose::features
