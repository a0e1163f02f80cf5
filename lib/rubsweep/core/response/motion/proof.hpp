#pragma once

#include <optional>
#include <string_view>

#include "rubsweep/core/response/motion/motion.hpp"

namespace rubsweep::response::motion {

/// Evidence for the class of a motion; each word says what is shown, up to rounding.
enum class Proof {
  rest,     ///< a bound on the free vibration: no contact can ever come again
  floquet,  ///< the run is inside a ball about a periodic orbit from which every motion converges to it
  /// Newton's iteration finds a periodic orbit (in a rotationally symmetric scene: a circle or a closed orbit
  /// in the frame that turns with the shaft) with all its multipliers inside the unit circle, and the run has
  /// been followed towards it over orders of magnitude; no ball about it is known.
  floquet_observed,
  observed,  ///< by the end of the run: windows that agree, a comb that closes, an exponent
};

constexpr std::string_view to_string(Proof proof) {
  switch (proof) {
    case Proof::rest:
      return "rest";
    case Proof::floquet:
      return "floquet";
    case Proof::floquet_observed:
      return "floquet_observed";
    case Proof::observed:
      return "observed";
  }
  return "";
}

/// A motion that a transient is proven to settle on.
struct ProvenMotion {
  MotionClass motion_class = MotionClass::synchronous;  ///< of a period, or quasi_periodic
  std::optional<int> order;                             ///< in turns; empty when quasi-periodic
  Measures measures;                                    ///< of the orbit itself
  double floquet_modulus = 0;                           ///< largest multiplier over its period, < 1
  Proof proof = Proof::floquet_observed;                ///< or floquet
};

}  // namespace rubsweep::response::motion
