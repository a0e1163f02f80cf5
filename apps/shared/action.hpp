#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::apps {

enum class Action { run, check, explain, print_config, help, version };

/// Arguments common to all programs that read a configuration file.
struct StudyArguments {
  Action action = Action::run;  ///< help and version leave all other members unset
  std::filesystem::path config;
  std::optional<std::filesystem::path> output;
  std::vector<std::string> overrides;  ///< `key.path=value` from every --set
  bool quiet = false;
};

/// Prints the answer to --help or --version and returns true; returns false for other actions.
bool answered(std::string_view program, Action action, const std::function<std::string()>& help);

/// A program's functions for the actions on a configuration.
struct StudyActions {
  std::function<std::string()> size, explanation,
      configuration;  ///< answers to --check, --explain, --print-config
  std::function<int()> run;
};

/// Carries out the action and returns an exit code.
int act(const StudyArguments& arguments, const StudyActions& actions);

}  // namespace rubsweep::apps
