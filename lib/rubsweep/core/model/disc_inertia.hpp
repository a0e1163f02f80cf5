#pragma once

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::model {

/// Largest polar moment of inertia that goes with the diametral one of a disc: no body has more than twice as
/// much, which a thin disc comes to. A thousandth more is the rounding of data sheets.
inline double largest_polar_inertia_kg_m2(const Disc& disc) {
  return 2.002 * disc.diametral_inertia_kg_m2;
}

}  // namespace rubsweep::model
