#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::apps {

enum class Action { run, check, explain, print_config, help, version };

/// Arguments of every program that reads a configuration file.
struct StudyArguments {
  Action action = Action::run;  ///< help and version: nothing else is filled in
  std::filesystem::path config;
  std::optional<std::filesystem::path> output;
  std::vector<std::string> overrides;  ///< `key.path=value` of every --set
  bool quiet = false;
};

/// Prints the answer to --help and --version; false for any other action.
bool answered(std::string_view program, Action action, const std::function<std::string()>& help);

/// Functions of a program for each action on a configuration that was read.
struct StudyActions {
  std::function<std::string()> size, explanation,
      configuration;  ///< answers to --check, --explain, --print-config
  std::function<int()> run;
};

/// Carries out the action and returns an exit code.
int act(const StudyArguments& arguments, const StudyActions& actions);

}  // namespace rubsweep::apps
