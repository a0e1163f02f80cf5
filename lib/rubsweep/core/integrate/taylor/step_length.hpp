#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/tangent_expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Largest product of a step and the fastest rate. Up to here a polynomial of order 24 treats the rounding in
/// an unexcited mode as the motion would, within 8^25 / 25! = 2e-3.
inline constexpr double longest_times_fastest = 8;

/// Largest such product with tangent vectors. These excite every mode as strongly as themselves, whatever the
/// motion does. The truncation error of e^x at order 23 is x^24 / 24!: x = 3.3 for 4e-12.
inline double longest_times_fastest_of_tangents(double accuracy) {
  constexpr int next = TangentExpansion<2>::order + 1;
  return std::min(longest_times_fastest, std::pow(accuracy * std::tgamma(next + 1), 1.0 / next));
}

/// Fastest rate per radian of the structure (`structure_rate`) together with the contact springs. The
/// eigenvalues of an underdamped oscillator have the size of its undamped frequency; those of an overdamped
/// one are not above its damping. `modes` per contact.
template <int N>
double fastest_rate(double structure_rate, const Expansion<N>& motion,
                    const std::vector<contact::Mode>& modes) {
  double square = structure_rate * structure_rate;
  double linear = 1;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == contact::Mode::open) continue;
    const ContactLaw& law = motion.law(i);
    square += std::max(law.stiffness, law.spring(modes[i])) * law.mobility;
    linear += law.damper(modes[i]) * law.mobility;
  }
  return std::max(linear, std::sqrt(square));
}

/// Largest turning rate, per radian, of the normals of touching contacts at the start of the expansion. The
/// stiffness in a fixed direction varies with twice this rate, which matters for tangent vectors.
template <int N>
double fastest_normal(const Expansion<N>& motion, const std::vector<contact::Mode>& modes) {
  double turning = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] != contact::Mode::open) turning = std::max(turning, std::abs(motion.contact(i).turn_rate()));
  }
  return turning;
}

}  // namespace rubsweep::integrate::taylor
