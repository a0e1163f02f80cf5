#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Reads what an instrument wrote; its first bytes say what it is: a MATLAB file, a WAV file or a table of
/// text (see matlab_file.hpp, sound_file.hpp, delimited_text.hpp). `bytes` are those of the file. Throws
/// ConfigError with its name, for a text with line and column.
Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace rubsweep::recording
