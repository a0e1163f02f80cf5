#pragma once

#include "rubsweep/model/friction.hpp"

namespace rubsweep::contact {

/// Coefficients of the friction curve from numbers that can be measured, as the IdealizedContact library
/// takes them (Oestersoetebier, Wang, Traechtler, 2014): g2 = g5 = 2 / peak speed, g3 = 3 / settle speed, g6
/// = viscous, g4 = kinetic - viscous * settle speed. g1 is solved for, so that the largest coefficient up to
/// the settling speed is `static_coefficient`; the library's closed form falls short of it. Throws
/// ConfigError where no g1 >= 0 does that.
model::StribeckFriction stribeck_of(const model::StribeckCurve& curve);

}  // namespace rubsweep::contact
