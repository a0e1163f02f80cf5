#pragma once

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::model {

/// Largest possible polar moment of inertia of a disc with this diametral one: twice as large, the limit of a
/// thin disc. A thousandth more allows for rounding in data sheets.
inline double largest_polar_inertia_kg_m2(const Disc& disc) { return 2.002 * disc.diametral_inertia_kg_m2; }

}  // namespace rubsweep::model
