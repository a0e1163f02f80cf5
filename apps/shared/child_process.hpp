#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubsweep::apps {

/// Path of a command among the directories of PATH; empty where there is none.
std::optional<std::filesystem::path> find_command(const std::string& name);

/// Descriptors that a child gets as its standard input and output; empty: those of this process.
struct ChildStreams {
  std::optional<int> input = {}, output = {};
};

/// Runs a command of PATH with its arguments, the name first, and waits for its end; true when it exits with
/// 0. Throws IoError where it cannot be started.
bool run_child(std::vector<std::string> command, const ChildStreams& streams = {});

/// How a child ended.
struct ChildEnd {
  int code = 0;  ///< exit code, or the number of the signal
  bool by_signal = false;
};

/// Runs `program` until it ends; `command` holds the name that it is called by, and its arguments. As soon as
/// `stop` is true it gets SIGTERM, once. A SIGINT does not reach it: a terminal sends that to both processes.
/// Throws IoError where it cannot be started.
ChildEnd run_child_until(const std::atomic<bool>& stop, const std::filesystem::path& program,
                         std::vector<std::string> command, const ChildStreams& streams = {});

/// Path of a program of this name beside this one, whether or not there is one.
std::filesystem::path sibling(const std::string& name);

/// Goes on as the program of this name that lies beside this one, with these arguments. Throws IoError where
/// there is none.
[[noreturn]] void become_sibling(const std::string& name, std::vector<std::string> arguments);

}  // namespace rubsweep::apps
