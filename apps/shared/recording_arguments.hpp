#pragma once

#include <filesystem>
#include <string_view>

#include "shared/action.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Arguments common to all programs that read a recording.
struct RecordingArguments {
  Action action = Action::run;  ///< help and version leave all other members unset
  bool quiet = false;
  std::filesystem::path recording = {};
  std::filesystem::path instrument = {};  ///< --instrument, else the recording's name with the ending .yaml
  std::filesystem::path directory = {};   ///< --output, else the recording's name with another ending
};

/// Adds --instrument.
void add_instrument(po::options_description& options);

/// Reads the command line of a program with one recording. Throws UsageError, like the next function.
po::variables_map read_recording_command_line(int argc, const char* const* argv,
                                              po::options_description options);

/// `usage`: how the program is called; `ending`: ending of the default output directory.
RecordingArguments recording_arguments(const po::variables_map& given, std::string_view usage,
                                       std::string_view ending);

}  // namespace rubsweep::apps
