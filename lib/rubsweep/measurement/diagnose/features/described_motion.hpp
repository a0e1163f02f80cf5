#pragma once

#include <Eigen/Core>

#include "rubsweep/measurement/diagnose/features/line_features.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::features {

/// Direction in which a motion of two probes is lopsided: the angle of the mean of |z|^2 z, rad from +x to
/// +y. What a flat stop cuts off is missing there.
double lopsided_direction(const Eigen::VectorXcd& waveform);

/// Features of the orbit: how round, lopsided and three-cornered it is, its extent along the lopsided
/// direction and across it, its radii, and its whirl. `waveform`: x + iy about the mean, equidistant samples
/// of whole turns.
Features orbit_features(const Eigen::VectorXcd& waveform);

/// The same of one probe: moments and extent of the signal.
Features signal_features(const Eigen::VectorXd& waveform);

/// Phases that lines have to each other, as points inside the unit circle: nearer to the middle where the
/// lines are weak. `plane`: two probes; else the motion is real.
Features phase_features(const MotionLines& lines, bool plane);

/// A motion as it is compared with others: features that do not depend on its size and direction, and these
/// two.
struct DescribedMotion {
  Features features{};
  double size_m = 0;         ///< root mean square about the mean
  double direction_rad = 0;  ///< lopsided_direction; of one probe 0
};

/// Parts of a recording that mean something.
struct View {
  bool plane = true;        ///< two probes; else one, where only lines from order 0 on are looked at
  bool directions = false;  ///< the machine is not the same in all directions
  bool from_rest = false;   ///< readings count from where the rotor rests, so that their mean does, too
};

/// Features of the lines and of the orbit; with directions those of its longest and of its lopsided axis,
/// from +x, with a mean its place in units of the motion's size.
DescribedMotion describe(const MotionLines& lines, const View& view,
                         response::spectrum::SpectrumWorkspace& workspace);

/// Values of features, in their order.
Eigen::VectorXd values_of(const Features& features);

}  // namespace rubsweep::diagnose::features
