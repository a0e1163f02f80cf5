#pragma once

namespace rubsweep::model {

/// Revolutions per minute of one turn per second.
inline constexpr double rpm_per_hz = 60;

}  // namespace rubsweep::model
