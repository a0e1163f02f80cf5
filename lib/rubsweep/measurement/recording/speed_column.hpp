#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"

namespace rubsweep::recording {

/// Begins of turns by a column of the shaft's speed, which is taken to be straight between its readings, and
/// across its gaps: the first reading takes the mark's place. Throws ConfigError, `name` of the file first,
/// for a unit that is none of a speed, a speed below 0 and one above half the sampling rate.
std::vector<double> turns_by_speed(const Channels& channels, const SpeedColumn& speed,
                                   const SampleClock& clock, const std::string& name);

/// Speed over that of the column, where the line of the shaft is off by more than a thousandth of a turn over
/// all turns and by three of its uncertainties, told in `findings`; nothing else, and for speeds that change
/// by more than 2 %. `probes` are readings on the clock.
std::optional<double> speed_factor(const std::vector<std::vector<double>>& probes, const SampleClock& clock,
                                   std::span<const double> turn_begin_s, std::vector<std::string>& findings);

}  // namespace rubsweep::recording
