#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::apps {

enum class Action { run, check, explain, print_config, help, version };

/// What every program that reads a configuration file is told.
struct StudyArguments {
  Action action = Action::run;  ///< help and version: nothing else is filled in
  std::filesystem::path config;
  std::optional<std::filesystem::path> output;
  std::vector<std::string> overrides;  ///< `key.path=value` of every --set
  bool quiet = false;
};

/// Prints what --help and --version ask for; false where something else is asked for.
bool answered(std::string_view program, Action action, const std::function<std::string()>& help);

/// What a program does with a configuration that is read, for each action.
struct StudyActions {
  std::function<std::string()> size, explanation, configuration;  ///< of --check, --explain, --print-config
  std::function<int()> run;
};

/// Does what is asked for and returns an exit code.
int act(const StudyArguments& arguments, const StudyActions& actions);

}  // namespace rubsweep::apps
