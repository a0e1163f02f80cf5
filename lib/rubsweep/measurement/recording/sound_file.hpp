#pragma once

#include <filesystem>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::recording {

/// Unit of a sound file's readings: shares of the converter's full scale, from -1 to 1.
inline constexpr const char* full_scale_unit = "FS";

/// Reads a WAV file (RIFF, RIFX, RF64) as data recorders write them: "channel 1", "channel 2", ... in
/// full_scale_unit, and its sampling rate. Throws ConfigError with the name of the file where it is damaged
/// or has fewer than two readings.
Channels read_sound_file(const std::filesystem::path& file);

}  // namespace rubsweep::recording
