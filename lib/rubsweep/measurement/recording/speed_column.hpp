#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/sample_clock.hpp"

namespace rubsweep::recording {

/// Beginnings of turns, computed from a column of the shaft's speed. The first turn begins with the first
/// reading, since there is no mark. The speed is interpolated linearly between its readings and across its
/// gaps. Throws ConfigError, `name` of the file first, for a unit that is not one of speed, for a speed below
/// 0, and for a speed above half the sampling rate.
std::vector<double> turns_by_speed(const Channels& channels, const SpeedColumn& speed,
                                   const SampleClock& clock, const std::string& name);

/// Ratio of the speed in the signal to the speed in the column, where it changes the angle over all turns by
/// more than a thousandth of a turn and exceeds three of its uncertainties. It is then reported in
/// `findings`. Otherwise, and for speeds that change by more than 2 %, empty. `probes`: readings at the
/// instants of `clock`.
std::optional<double> speed_factor(const std::vector<std::vector<double>>& probes, const SampleClock& clock,
                                   std::span<const double> turn_begin_s, std::vector<std::string>& findings);

}  // namespace rubsweep::recording
