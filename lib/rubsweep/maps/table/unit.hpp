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
  rate,     ///< 1/s, which may mean turns or radians per second
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

/// A unit, with its size in SI units. The basis for shaft speeds is one turn per second, for angles the
/// radian, for temperatures the kelvin (without an offset), for shares one.
struct Unit {
  Quantity quantity = Quantity::share;
  double in_si = 1;
};

/// The unit that these words name, in the spelling of people: "N-s/m" and "N s/m" are the same unit, and so
/// are "um" with either sign for micro. Capital letters matter only in units with M, k or N (MN/m is not
/// mN/m). Empty where the unit is unknown.
std::optional<Unit> unit_of(std::string_view words);

inline constexpr double newtons_per_lbf = 4.4482216152605, metres_per_inch = 0.0254;
inline constexpr double standard_gravity = 9.80665;  ///< g in m/s^2
/// One pound-force per inch, in N/m.
inline constexpr double lbf_per_in = newtons_per_lbf / metres_per_inch;

}  // namespace rubsweep::table
