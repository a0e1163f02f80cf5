#pragma once

#include "rubsweep/core/model/friction.hpp"

namespace rubsweep::contact {

/// Largest allowed ratio of settling speed to peak speed: beyond it the peak is numerically invisible.
inline constexpr double largest_settle_over_peak = 1e6;

/// Coefficients of the friction curve from measurable numbers, by the formulas of the IdealizedContact
/// library (Oestersoetebier, Wang, Traechtler, 2014): g2 = g5 = 2 / peak speed, g3 = 3 / settle speed, g6 =
/// viscous, g4 = kinetic - viscous * settle speed. g1 is found numerically so that the largest coefficient up
/// to the settling speed is `static_coefficient`; with the library's closed form it would be smaller. Throws
/// ConfigError where no such g1 >= 0 exists, or the speeds are too far apart.
model::StribeckFriction stribeck_of(const model::StribeckCurve& curve);

}  // namespace rubsweep::contact
