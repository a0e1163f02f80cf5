#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rubsweep::apps {

/// Path of a command in the directories of PATH; empty where it is not found.
std::optional<std::filesystem::path> find_command(const std::string& name);

/// File descriptors for a child's standard input and output; empty: those of this process.
struct ChildStreams {
  std::optional<int> input = {}, output = {};
};

/// Runs a command found in PATH and waits for its end; its arguments begin with its name. Returns whether it
/// exits with 0. Throws IoError where it cannot be started.
bool run_child(std::vector<std::string> command, const ChildStreams& streams = {});

/// Way in which a child ended.
struct ChildEnd {
  int code = 0;  ///< exit code, or the number of the signal
  bool by_signal = false;
};

/// Runs `program` until it ends; `command` is its name and its arguments. When `stop` becomes true, the child
/// gets one SIGTERM. SIGINT is blocked in the child, because a terminal sends it to both processes. Throws
/// IoError where the child cannot be started.
ChildEnd run_child_until(const std::atomic<bool>& stop, const std::filesystem::path& program,
                         std::vector<std::string> command, const ChildStreams& streams = {});

/// Path that a program of this name would have beside this one; it need not exist.
std::filesystem::path sibling(const std::string& name);

/// Replaces this process by the program of this name that lies beside it. Throws IoError where there is none.
[[noreturn]] void become_sibling(const std::string& name, std::vector<std::string> arguments);

}  // namespace rubsweep::apps
