#pragma once

namespace rubsweep::model {

/// Furthest place that is taken for the end of a shaft. Its length is a sum of segments, whose rounding
/// depends on their order, and a part at the end is given by a number of its own. Far nearer than what makes
/// two stations one, and too near to be seen in a message (describe).
inline double furthest_place_m(double length_m) {
  constexpr double rounding = 1e-10;
  return length_m * (1 + rounding);
}

}  // namespace rubsweep::model
