#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::apps {

struct RubtraceArguments {
  bool help = false, version = false;  ///< true: nothing else is filled in
  std::filesystem::path config;
  double speed_hz = 0;
  scene::Unbalance unbalance;
  std::optional<long> revolutions;
  std::optional<long> last_revolutions;
  std::optional<std::filesystem::path> output;
  std::vector<std::string> overrides;  ///< `key.path=value` of every --set
  bool quiet = false;
};

/// Throws UsageError (program.hpp).
RubtraceArguments parse_rubtrace_arguments(int argc, const char* const* argv);

/// Text of --help.
std::string rubtrace_help();

}  // namespace rubsweep::apps
