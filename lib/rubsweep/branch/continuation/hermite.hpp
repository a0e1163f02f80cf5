#pragma once

#include <Eigen/Core>

namespace rubsweep::branch::continuation {

/// A point of a curve and its unit tangent there.
struct PointAndTangent {
  const Eigen::VectorXd& at;
  const Eigen::VectorXd& tangent;
};

/// Near the curve between two of its points, on the plane at the distance s along the tangent of the first:
/// from a cubic through both points along both tangents, whose s is that of the plane up to what the tangents
/// turn. `length`: of the piece along the first tangent.
inline Eigen::VectorXd hermite_guess(const PointAndTangent& from, const PointAndTangent& to, double length,
                                     double s) {
  const double t = s / length, u = 1 - t;
  const Eigen::VectorXd guess = u * u * (1 + 2 * t) * from.at + t * t * (3 - 2 * t) * to.at +
                                length * t * u * (u * from.tangent - t * to.tangent);
  return guess + (s - from.tangent.dot(guess - from.at)) * from.tangent;
}

}  // namespace rubsweep::branch::continuation
