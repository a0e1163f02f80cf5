#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/measurement/recording/channels.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::recording {

/// Reads a table as instruments write it (table/layout.hpp): text before the table, cells separated by tabs,
/// semicolons or commas, decimal points or commas, comments after '#' or '%', line ends of any system, UTF-8,
/// UTF-16 or Latin-1. A unit stands in brackets after the name or in a line below the names. Names ending in
/// _s or _m are in seconds or metres; columns without a name are "column 1", "column 2", ... Columns of text
/// are left out. A first column of time stamps (12:30:01.25, with or without a date) becomes seconds since
/// the first one; without a date it may pass midnight. Of LabVIEW's .lvm format one segment is read, with the
/// units and the sampling rate of its header. Throws ConfigError with `name`:line:column for a cell that is
/// not a number, a row of wrong length, and a text without numbers.
Channels read_delimited_text(std::string_view bytes, const std::string& name);

/// Reads the numeric variables of a MATLAB file, version 4, 5 or 7.3. A vector is a channel with the name of
/// the variable. The columns of a matrix, or its rows where these are longer, are NAME_1, NAME_2, ...; the
/// fields of a structure are STRUCTURE.FIELD. Names ending in _s or _m are in seconds or metres. Variables
/// that are not signals are left out and reported, also channels shorter than the longest ones, which are
/// usually settings. Throws ConfigError with `name` where the file is damaged or has no signal of two or more
/// numbers.
Channels read_matlab_file(std::string_view bytes, const std::string& name);

/// Reads an instrument's file. Its first bytes tell the format: a MATLAB file, a WAV file or a table of text.
/// `bytes` is the content of the file. Throws ConfigError with the file's name, and with line and column for
/// a text.
Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes);

/// A recording with the text of its files.
struct ReadRecording {
  Recording recording;
  Instrument instrument;
  std::string text;  ///< text of the instrument's file, then of the recording; a digest is computed from both
};

/// Reads a recording and the description of its instrument. Throws ConfigError for faults in either file.
ReadRecording read_recording(const std::filesystem::path& file, const std::filesystem::path& instrument_file);

/// Reads a WAV file (RIFF, RIFX, RF64) as data recorders write it: "channel 1", "channel 2", ... in
/// full_scale_unit, and the sampling rate. Throws ConfigError with the name of the file where it is damaged
/// or has fewer than two readings.
Channels read_sound_file(const std::filesystem::path& file);

}  // namespace rubsweep::recording
