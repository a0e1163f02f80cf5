#pragma once

#include <Eigen/Core>

#include "rubsweep/diagnose/features/feature.hpp"
#include "rubsweep/diagnose/motion_lines.hpp"

namespace rubsweep::diagnose::features {

/// A motion as it is compared with others: features that do not depend on its size and direction, and these
/// two.
struct DescribedMotion {
  Features features{};
  double size_m = 0;         ///< root mean square about the mean
  double direction_rad = 0;  ///< lopsided_direction; of one probe 0
};

/// `plane`: lines of two probes; else of one, where only those from order 0 on are looked at.
DescribedMotion describe(const MotionLines& lines, bool plane,
                         response::spectrum::SpectrumWorkspace& workspace);

/// Values of features, in their order.
Eigen::VectorXd values_of(const Features& features);

}  // namespace rubsweep::diagnose::features
