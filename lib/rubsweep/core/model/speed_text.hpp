#pragma once

#include <string>

namespace rubsweep::model {

/// Revolutions per minute in one revolution per second.
inline constexpr double rpm_per_hz = 60;

/// A shaft speed (Hz) as text: "75 Hz (4500 rpm)", each number rounded to `digits` significant digits.
std::string speed_text(double speed_hz, int digits = 6);

/// A range of shaft speeds (Hz) as text: "50 to 150 Hz (3000 to 9000 rpm)".
std::string speed_range_text(double from_hz, double to_hz, int digits = 6);

}  // namespace rubsweep::model
