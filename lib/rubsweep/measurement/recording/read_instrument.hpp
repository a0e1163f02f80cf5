#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/instrument.hpp"

namespace rubsweep::config::recording {

/// Reads what has to be known of a recording: probes (a list of one or two, each with column, angle_deg and
/// perhaps gain_mv_per_um, unit, range_v), keyphasor (column, mark, threshold, hysteresis) or speed_hz, time
/// (the name of a column) or sampling_rate_hz or none of both; from_s, to_s; run_out (from_s, to_s,
/// subtract). `name` stands for the file in messages. Throws ConfigError with every problem.
rubsweep::recording::Instrument read_instrument_text(std::string_view text, const std::string& name);

}  // namespace rubsweep::config::recording
