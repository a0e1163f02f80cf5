#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/dataset/labelled_recording.hpp"

namespace rubsweep::dataset {

/// Ending of the file that becomes a MATLAB file once it is whole, before that of a temporary.
inline constexpr std::string_view scratch_ending = ".part";

/// t_s, x_m, y_m (of two probes), keyphasor_v: time with twelve digits, so that it goes on at
/// every reading, and the others with seven.
std::string recording_csv(const LabelledRecording& recording);

/// Writes the same columns as variables of a MATLAB file, version 5, compressed; its head is the same in
/// every run. Whole or not at all. Returns the bytes of the file. Throws IoError.
std::string write_recording_matlab(const LabelledRecording& recording, const std::filesystem::path& file);

}  // namespace rubsweep::dataset
