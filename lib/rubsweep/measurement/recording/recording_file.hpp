#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/delimited_text.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::recording {

/// Reads the numeric variables of a MATLAB file, version 4, 5 or 7.3. A vector is a channel with the name of
/// the variable. The columns of a matrix (its rows, if these are longer) are NAME_1, NAME_2, ... The fields
/// of a structure are STRUCTURE.FIELD, also inside structures and cells: A.B(2).C{3}. Names that end with _s
/// or _m are in seconds or metres. A single number with a name such as fs or dt is the clock. Channels
/// shorter than the longest ones are settings saved beside the signals. They are left out with a note, like
/// everything else that is no signal. Throws ConfigError with `name` where the file is damaged or holds no
/// signal of two numbers or more.
Channels read_matlab_file(std::string_view bytes, const std::string& name);

/// Reads a recording in any supported format. The first bytes of the file decide its format: a MATLAB file, a
/// WAV file, a TDMS file (tdms_file.hpp), a universal file (universal_file.hpp) or a table of text
/// (delimited_text.hpp). `bytes`: the content of the file. Throws ConfigError with its name, for a text with
/// line and column.
Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes);

/// A recording with the text of its files.
struct ReadRecording {
  Recording recording;
  Instrument instrument;
  std::string text;  ///< text of the instrument's file, then of the recording; a digest is computed from both
};

/// Reads a recording and the description of its instrument. Throws ConfigError for faults in either file.
/// `turns_of_sweep` finds the turns of one whose description has a sweep; empty: such a recording is refused.
using FindTurns = FollowedTurns (*)(const Channels&, const Instrument&, const std::string& name);
ReadRecording read_recording(const std::filesystem::path& file, const std::filesystem::path& instrument_file,
                             FindTurns turns_of_sweep = nullptr);

/// Reads a WAV file (RIFF, RIFX, RF64) as data recorders write it: "channel 1", "channel 2", ... in
/// full_scale_unit, and the sampling rate. Throws ConfigError with the name of the file where it is damaged
/// or has fewer than two readings.
Channels read_sound_file(const std::filesystem::path& file);

}  // namespace rubsweep::recording
