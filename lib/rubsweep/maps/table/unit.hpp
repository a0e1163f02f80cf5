#pragma once

#include <optional>
#include <string_view>

namespace rubsweep::table {

/// Kinds of quantities that units measure.
enum class Quantity {
  time,
  length,
  velocity,
  acceleration,
  angle,
  turning,  ///< speed of a shaft
  rate,     ///< 1/s, which may be of turns or of radians
  voltage,
  current,
  force,
  stiffness,
  damping,
  mass,
  pressure,
  temperature,
  share,
};

/// A unit by its size: how many of the SI unit it is. Of speeds of a shaft that is one turn in a second, of
/// angles the radian, of temperatures the kelvin (without their origin), of shares one.
struct Unit {
  Quantity quantity = Quantity::share;
  double in_si = 1;
};

/// The unit of these words, as people write it: "N-s/m" and "N s/m" are one, and so are "um" with either sign
/// for micro. Capital letters count where M, k and N stand together (MN/m is not mN/m), else they do not.
/// Empty where it is unknown.
std::optional<Unit> unit_of(std::string_view words);

inline constexpr double newtons_per_lbf = 4.4482216152605, metres_per_inch = 0.0254;
inline constexpr double standard_gravity = 9.80665;  ///< g in m/s^2
/// A pound of force by an inch, in N/m.
inline constexpr double lbf_per_in = newtons_per_lbf / metres_per_inch;

}  // namespace rubsweep::table
