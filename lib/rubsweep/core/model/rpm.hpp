#pragma once

namespace rubsweep::model {

/// Revolutions per minute in one revolution per second.
inline constexpr double rpm_per_hz = 60;

}  // namespace rubsweep::model
