#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads the numeric variables of a MATLAB file, version 4, 5 or 7.3: a vector is a channel with the name of
/// the variable, the columns of a matrix are NAME_1, NAME_2, ..., or its rows where these are longer; of a
/// structure its fields, STRUCTURE.FIELD. Names that end with _s or _m are in seconds or metres. Channels
/// shorter than the longest ones are left out, settings that were saved beside the signals, and told as such,
/// as is all else that is no signal. Throws ConfigError with `name` where the file is damaged or holds no
/// signal of two numbers or more.
Channels read_matlab_file(std::string_view bytes, const std::string& name);

}  // namespace rubsweep::recording
