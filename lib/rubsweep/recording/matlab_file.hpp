#pragma once

#include <filesystem>

#include "rubsweep/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads the numeric variables of a MATLAB file, version 4, 5 or 7.3: a vector is a channel with the name of
/// the variable, the columns of a matrix are NAME_1, NAME_2, ...; of a structure its fields, STRUCTURE.FIELD.
/// Names that end with _s or _m are in seconds or metres. Channels shorter than the longest ones are left
/// out: settings that were saved beside the signals. Throws ConfigError with the name of the file where it is
/// damaged or holds no signal of two numbers or more.
Channels read_matlab_file(const std::filesystem::path& file);

}  // namespace rubsweep::recording
