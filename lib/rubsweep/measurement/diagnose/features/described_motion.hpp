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

/// Phases of the lines relative to each other, as points inside the unit circle. The points of weak lines lie
/// near its centre. `plane`: true with two probes; with one probe the motion is real.
Features phase_features(const MotionLines& lines, bool plane);

/// Description of a motion for comparisons: features that do not depend on size or direction, and in addition
/// size and direction.
struct DescribedMotion {
  Features features{};
  double size_m = 0;         ///< root mean square about the mean
  double direction_rad = 0;  ///< lopsided_direction, rad; 0 for one probe
};

/// Parts of a recording that can be interpreted.
struct View {
  /// true: two probes; false: one probe, and only lines of order 0 and above are used
  bool plane = true;
  bool directions = false;  ///< whether the machine is anisotropic, so that directions carry information
  /// whether readings are measured from the rest position, so that their mean carries information
  bool from_rest = false;
};

/// Features of the lines and of the orbit. With `view.directions`, the directions of the longest and of the
/// lopsided axis, measured from +x, are features, too. With `view.from_rest`, so is the mean position in
/// units of the motion's size.
DescribedMotion describe(const MotionLines& lines, const View& view,
                         response::spectrum::SpectrumWorkspace& workspace);

/// Values of the features as a vector, in the same order.
Eigen::VectorXd values_of(const Features& features);

}  // namespace rubsweep::diagnose::features
