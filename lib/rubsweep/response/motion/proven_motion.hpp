#pragma once

#include <optional>

#include "rubsweep/response/motion/motion.hpp"
#include "rubsweep/response/motion/proof.hpp"

namespace rubsweep::response::motion {

/// A motion that a transient is proven to settle on.
struct ProvenMotion {
  MotionClass motion_class = MotionClass::synchronous;  ///< of a period, or quasi_periodic
  std::optional<int> order;                             ///< in turns; empty when quasi-periodic
  Measures measures;                                    ///< of the orbit itself
  double floquet_modulus = 0;                           ///< largest multiplier over its period, < 1
  Proof proof = Proof::floquet_observed;                ///< or floquet
};

}  // namespace rubsweep::response::motion
