#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"

namespace rubsweep::recording {

/// Instants of the samples: the first instant and the sampling rate.
struct SampleClock {
  double first_s = 0, rate_hz = 0;
};

/// The column with this name, or with the number in "column 3". Throws ConfigError, `name` of the file first,
/// where there is no such column or more than one.
const Channel& find_channel(const Channels& channels, const std::string& column, const std::string& name);

/// Clock from the column of times, from the sampling rate in the description, or from the file's own rate.
/// Throws ConfigError (with `name`:line where a row is at fault) for times that do not ascend or are uneven,
/// for missing times, and for an interval (from_s, to_s) outside the recording.
SampleClock clock_of(const Channels& channels, const Instrument& instrument, const std::string& name);

/// The longest stretch of rows, between from_s and to_s, in which the time does not jump ahead; adds a
/// sentence to `findings`. Empty where the time does not jump, where it also steps back, or where it jumps so
/// often that it counts as uneven.
std::optional<Channels> stretch_without_jump(const Channels& channels, const Instrument& instrument,
                                             const std::string& name, std::vector<std::string>& findings);

}  // namespace rubsweep::recording
