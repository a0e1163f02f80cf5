#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"

namespace rubsweep::recording {

/// Instants of the samples: the first one and how many there are a second.
struct SampleClock {
  double first_s = 0, rate_hz = 0;
};

/// The column of that name, or by its number: "column 3". Throws ConfigError, `name` of the file first, where
/// there is none or more than one.
const Channel& find_channel(const Channels& channels, const std::string& column, const std::string& name);

/// Clock of the column of times, of the sampling rate that the description says, or of the file's own. Throws
/// ConfigError, with `name`:line where a row is at fault, for times that do not rise or are not evenly
/// spaced, where nothing says the times, and for a stretch (from_s, to_s) that leaves none of the recording.
SampleClock clock_of(const Channels& channels, const Instrument& instrument, const std::string& name);

/// The longest stretch of rows in which the column of times does not jump ahead, as far as from_s and to_s
/// leave it, and a sentence for `findings`; nothing where it does not jump, steps back too, or jumps so often
/// that it is uneven.
std::optional<Channels> stretch_without_jump(const Channels& channels, const Instrument& instrument,
                                             const std::string& name, std::vector<std::string>& findings);

}  // namespace rubsweep::recording
