#pragma once

#include <optional>
#include <string>

namespace rubsweep::recording {

/// Seconds per unit of a column of times: s (also without a unit), ms, us or µs. Throws ConfigError with the
/// names of file and column for any other.
double seconds_per(const std::string& unit, const std::string& column, const std::string& file);

/// Metres per unit of a probe's column: m, mm, um or µm, mil; V or mV with a gain in mV/µm, and no gain for
/// the others. Throws ConfigError as above.
double metres_per(const std::string& unit, const std::string& column, std::optional<double> gain_mv_per_um,
                  const std::string& file);

}  // namespace rubsweep::recording
