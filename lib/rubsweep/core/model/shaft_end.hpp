#pragma once

namespace rubsweep::model {

/// Largest position that counts as the end of a shaft. The length is a sum of segments whose rounding depends
/// on their order, while the position of a part at the end is given as one number. The tolerance is much
/// smaller than the distance at which two stations become one, and too small to show in a message (describe).
inline double furthest_place_m(double length_m) {
  constexpr double rounding = 1e-10;
  return length_m * (1 + rounding);
}

}  // namespace rubsweep::model
