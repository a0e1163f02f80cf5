#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/design/damped_stability.hpp"
#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/analysis/ramp/ramp_run.hpp"

namespace rubsweep::apps {

/// Evenly spaced speeds of a Campbell diagram.
struct CampbellSpeeds {
  double from_hz = 0, to_hz = 0;
  int count = 101;
};

/// Reads FROM:TO:RATE of --run-up, in Hz and Hz/s. Throws UsageError.
ramp::SpeedRamp ramp_of(const std::string& text);

/// Reads FROM:TO or FROM:TO:COUNT of --campbell, in Hz. Throws UsageError.
CampbellSpeeds campbell_speeds_of(const std::string& text);

/// Reads FROM:TO of `option`; `per_hz` is the number of the option's units in 1 Hz. Throws UsageError.
design::SpeedRange operating_range_of(const char* option, const std::string& text, double per_hz);

/// Reads the values of --stage: impellers, blades, or "none" alone, which gives no stage. Throws UsageError.
std::vector<design::Stage> stages_of(const std::vector<std::string>& texts);

}  // namespace rubsweep::apps
