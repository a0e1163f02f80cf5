#pragma once

#include "rubsweep/core/model/friction.hpp"

namespace rubsweep::contact {

/// A curve that settles farther beyond its peak than this has no peak that numbers could show.
inline constexpr double largest_settle_over_peak = 1e6;

/// Coefficients of the friction curve from numbers that can be measured, as the IdealizedContact library
/// takes them (Oestersoetebier, Wang, Traechtler, 2014): g2 = g5 = 2 / peak speed, g3 = 3 / settle speed, g6
/// = viscous, g4 = kinetic - viscous * settle speed. g1 is solved for, so that the largest coefficient up to
/// the settling speed is `static_coefficient`; the library's closed form falls short of it. Throws
/// ConfigError where no g1 >= 0 does that, or the speeds are too far apart.
model::StribeckFriction stribeck_of(const model::StribeckCurve& curve);

}  // namespace rubsweep::contact
