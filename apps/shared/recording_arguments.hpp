#pragma once

#include <filesystem>
#include <string_view>

#include "shared/action.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Arguments of every program that reads a recording.
struct RecordingArguments {
  Action action = Action::run;  ///< help and version: nothing else is filled in
  bool quiet = false;
  std::filesystem::path recording = {};
  std::filesystem::path instrument = {};  ///< file of --instrument, else the recording with the ending .yaml
  std::filesystem::path directory =
      {};  ///< directory of --output, else the recording without its ending and with another
};

/// --instrument.
void add_instrument(po::options_description& options);

/// Reads the command line of a program that takes one recording. Throws UsageError, as the next one.
po::variables_map read_recording_command_line(int argc, const char* const* argv,
                                              po::options_description options);

/// `usage`: how the program is called; `ending`: of the directory where --output does not name one.
RecordingArguments recording_arguments(const po::variables_map& given, std::string_view usage,
                                       std::string_view ending);

}  // namespace rubsweep::apps
