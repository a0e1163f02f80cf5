#pragma once

#include <optional>
#include <string>

#include "rubsweep/measurement/recording/instrument.hpp"

namespace rubsweep::recording {

/// Seconds per unit of a column of times: s (also without a unit), ms, us or µs. Throws ConfigError with the
/// names of file and column for any other.
double seconds_per(const std::string& unit, const std::string& column, const std::string& file);

/// How readings of a probe become metres, and where they are cut off.
struct Scale {
  double metres_per_unit = 1;
  std::optional<double> full_scale{};  ///< in the unit of the column
};

/// Scale of a probe's column: m, mm, um or µm, mil; V or mV with a gain in mV/µm; FS, shares of a full scale
/// of range_v, with both. `unit` is that of the column unless the probe says another one. Throws ConfigError
/// as above.
Scale scale_of(const std::string& unit, const Probe& probe, const std::string& file);

}  // namespace rubsweep::recording
