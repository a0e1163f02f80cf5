#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a TDMS file of LabVIEW. Each channel of numbers or time stamps is a signal with its unit, named like
/// the channel, or GROUP/NAME where two groups have a channel of this name. If all channels have the same
/// wf_increment, it gives the sampling rate. Channels of text, and channels shorter than the longest ones,
/// are left out with a note. Throws ConfigError with `name` where the file is damaged, holds raw data of
/// DAQmx, or no signal.
Channels read_tdms_file(std::string_view bytes, const std::string& name);

}  // namespace rubsweep::recording
