#pragma once

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Jeffcott rotor: one disc in the middle of a massless isotropic shaft, with the displacement z = x + iy and
/// m z'' + c z' + k z = forces. (Ishibashi & Kawai, section 3; the lowest bending frequency is their
/// epsilon_L.)
struct JeffcottRotor {
  double mass_kg = required;
  double natural_frequency_hz = required;  ///< undamped, sqrt(k/m)/(2 pi)
  double damping_ratio = required;         ///< c / (2 sqrt(k m)); 0 and values above 1 are allowed
  /// Ratio of the damping that rotates with the shaft (in its material and joints), as for damping_ratio: the
  /// force is -c_r (z' - i w z) with c_r = 2 sqrt(k m) times this ratio. Above the speed sqrt(k/m) (1 +
  /// damping_ratio / this ratio) the shaft is unstable and starts to whirl by itself.
  double rotating_damping_ratio = 0;

  static void visit_fields(auto& self, auto&& visit) {
    visit("mass_kg", self.mass_kg, key(positive, "mass of the disc: the modal mass there"));
    visit("natural_frequency_hz", self.natural_frequency_hz,
          key(positive, "undamped natural frequency, sqrt(k/m)/(2 pi)"));
    visit(
        "damping_ratio", self.damping_ratio,
        key(not_negative, "damping as a fraction of critical damping, c / (2 sqrt(k m)); of a kit by mode"));
    visit("rotating_damping_ratio", self.rotating_damping_ratio,
          newer_key(not_negative,
                    "the same of the damping that turns with the shaft, in its material and joints"));
  }
};

}  // namespace rubsweep::model
