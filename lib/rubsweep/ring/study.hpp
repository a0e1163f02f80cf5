#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/ring/chart.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// One run of `ringstab`.
struct Study {
  System system;
  std::vector<double> speeds_rpm;  ///< ascending
  std::optional<ChartAxis> chart;
  std::optional<batch::Spacing> spacing{};  ///< how the speeds are written; empty where they are listed
};

/// rad/s of one revolution per minute.
inline constexpr double rad_per_s_of_rpm = std::numbers::pi / 30;

inline std::vector<double> speeds_rad_per_s(const Study& study) {
  std::vector<double> speeds;
  for (const double speed : study.speeds_rpm) speeds.push_back(speed * rad_per_s_of_rpm);
  return speeds;
}

}  // namespace rubsweep::ring
