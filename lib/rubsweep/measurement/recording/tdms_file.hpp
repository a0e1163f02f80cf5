#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads a file of LabVIEW's TDMS: each channel of numbers or time stamps is a signal by its name, or
/// GROUP/NAME where two groups have the same, with its unit and, where all say the same wf_increment, the
/// sampling rate. Channels of text, and those shorter than the longest ones, are left out and told. Throws
/// ConfigError with `name` where the file is damaged, holds raw data of DAQmx, or no signal.
Channels read_tdms_file(std::string_view bytes, const std::string& name);

}  // namespace rubsweep::recording
