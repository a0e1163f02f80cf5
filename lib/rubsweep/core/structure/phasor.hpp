#pragma once

#include <complex>
#include <numbers>

namespace rubsweep::structure {

/// Complex number of a vector in the plane: its length, and its angle from +x towards +y in degrees.
inline std::complex<double> phasor(double amplitude, double phase_deg) {
  return std::polar(amplitude, phase_deg * std::numbers::pi / 180);
}

}  // namespace rubsweep::structure
