#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/axis.hpp"

namespace rubsweep::sweep {

/// Form in which a person wrote speeds or unbalances, for output. No number of a map depends on it.
struct WrittenAxis {
  std::string key{};                        ///< such as speed_rpm; empty: in SI units
  std::string unit{};                       ///< such as "rpm" or "g mm"
  double units_per_si = 1;                  ///< how many of that unit are one in SI
  std::optional<batch::Spacing> spacing{};  ///< in that unit; empty where values were listed
  double rated_speed_hz = 0;                ///< of a balance grade alone

  bool is_si() const { return key.empty(); }
};

/// A number in SI units as text in the unit that it was written in. The 15 digits that are kept hide that it
/// was divided and multiplied: 3100 rpm do not come back as 3100.0000000000005.
std::string in_units(const WrittenAxis& axis, double si);

/// The text of in_units where it reads back as the same number in SI units, else empty.
std::optional<std::string> exactly_in_units(const WrittenAxis& axis, double si);

}  // namespace rubsweep::sweep
