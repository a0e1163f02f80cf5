#pragma once

#include <Eigen/Core>

namespace rubsweep::design {

/// Major axis of the ellipse x = Re(X e^{i w t}), y = Re(Y e^{i w t}), from end to end, in the unit of
/// `amplitude` = (X, Y). The forward circle has the radius |X + i Y| / 2, the backward one |X - i Y| / 2, and
/// their sum is half the axis: never less than the peak to peak of x or of y, and more where the ellipse
/// leans.
double major_axis(const Eigen::Vector2cd& amplitude);

}  // namespace rubsweep::design
