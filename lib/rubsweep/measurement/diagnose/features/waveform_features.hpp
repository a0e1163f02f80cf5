#pragma once

#include <Eigen/Core>

#include "rubsweep/measurement/diagnose/features/feature.hpp"

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

}  // namespace rubsweep::diagnose::features
