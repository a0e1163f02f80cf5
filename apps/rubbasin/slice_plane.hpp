#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::apps {

/// A number of the initial state, or a configuration key, named on the command line.
struct StartNumber {
  std::string key;                             ///< key of the configuration
  std::string column;                          ///< column of slice.csv: x_m, casing0_vx_m_per_s, or the key
  std::optional<std::size_t> casing;           ///< index of the stop with this casing
  bool is_state = false, is_velocity = false;  ///< state of rotor or casing; both false: a configuration key
};

/// Reads "x,vx", "casing0.y,vx" or two keys of the configuration. Throws UsageError.
std::array<StartNumber, 2> read_plane(const std::string& text);

/// Displacement and velocity of the rotor along the axis closest to the normal of the first stop: x and vx,
/// or y and vy. The normal of an annular stop points to the smallest gap.
std::array<StartNumber, 2> usual_plane(const model::Stop& first);

/// Evenly spaced values that include both ends.
struct StartRange {
  double from = 0, to = 0;
};

/// Default range of a slice: twice the clearance of the first stop in both directions, for velocities
/// multiplied by the angular speed. Throws UsageError for a configuration key, which has no default range.
StartRange usual_range(const StartNumber& number, const config::RunConfig& config, double speed_hz);

/// Throws UsageError where the machine has no such casing, or the casing is fixed.
void refuse_missing_casing(const StartNumber& number, const config::RunConfig& config);

}  // namespace rubsweep::apps
