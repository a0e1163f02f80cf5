#include "shared/recording_arguments.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "shared/program.hpp"

namespace rubsweep::apps {

void add_instrument(po::options_description& options) {
  options.add_options()(
      "instrument", po::value<std::string>()->value_name("FILE.yaml"),
      "probes, keyphasor and clock of the recording instead of RECORDING with the ending .yaml");
}

po::variables_map read_recording_command_line(int argc, const char* const* argv,
                                              po::options_description options) {
  options.add_options()("recording", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("recording", -1);
  return read_command_line(argc, argv, options, positional);
}

RecordingArguments recording_arguments(const po::variables_map& given, std::string_view usage,
                                       std::string_view ending) {
  RecordingArguments arguments{.action = action_of(given), .quiet = given.count("quiet") > 0};
  if (arguments.action != Action::run) return arguments;
  const auto names = given.count("recording") ? given["recording"].as<std::vector<std::string>>()
                                              : std::vector<std::string>{};
  if (names.size() != 1) throw UsageError(fmt::format("one recording is needed: {}", usage));
  arguments.recording = arguments.instrument = arguments.directory = names.front();
  arguments.instrument.replace_extension(".yaml");
  arguments.directory.replace_extension();
  arguments.directory += ending;
  if (given.count("instrument")) arguments.instrument = given["instrument"].as<std::string>();
  if (given.count("output")) arguments.directory = given["output"].as<std::string>();
  return arguments;
}

}  // namespace rubsweep::apps
