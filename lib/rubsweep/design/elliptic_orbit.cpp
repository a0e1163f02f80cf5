#include "rubsweep/design/elliptic_orbit.hpp"

#include <complex>

namespace rubsweep::design {

double major_axis(const Eigen::Vector2cd& amplitude) {
  const std::complex<double> turned = std::complex<double>(0, 1) * amplitude(1);
  return std::abs(amplitude(0) + turned) + std::abs(amplitude(0) - turned);
}

}  // namespace rubsweep::design
