#pragma once

#include <Eigen/Core>
#include <complex>

namespace rubsweep::scene {

/// Largest value of a motion with orders 1 and 2 of the speed, and the phase where it occurs.
struct TopOfMotion {
  double value = 0;
  double phase_rad = 0;  ///< 0 to 2 pi; the first one if several are equal
};

/// Largest value of Re(first e^{i phase} + second e^{2 i phase}). Infinite, at phase 0, where a number is not
/// finite.
TopOfMotion largest_value(std::complex<double> first, std::complex<double> second);

/// Largest length of the vector Re(first e^{i phase} + second e^{2 i phase}), whose components are real.
TopOfMotion largest_distance(const Eigen::Vector2cd& first, const Eigen::Vector2cd& second);

}  // namespace rubsweep::scene
