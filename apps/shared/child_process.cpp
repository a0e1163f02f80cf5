#include "shared/child_process.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <thread>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::apps {

std::optional<std::filesystem::path> find_command(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::filesystem::path candidate = std::filesystem::path(rest.substr(0, colon)) / name;
    std::error_code none;
    if (std::filesystem::is_regular_file(candidate, none) && ::access(candidate.c_str(), X_OK) == 0)
      return candidate;
    rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
  }
  return std::nullopt;
}

namespace {

/// Interval at which a child and signals are checked.
constexpr std::chrono::milliseconds patience{10};

/// Argument list for exec; it points into `command`, which must outlive it.
std::vector<char*> as_argv(std::vector<std::string>& command) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  return arguments;
}

/// Starts a command found in PATH, or one with a directory in its name. Signals blocked in this process are
/// not blocked in the child, except `held`.
pid_t start(const std::string& program, std::vector<std::string> command, const ChildStreams& streams,
            std::optional<int> held) {
  // If the parent of this process ignores SIGCHLD, exit codes of children would be lost.
  std::signal(SIGCHLD, SIG_DFL);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  if (streams.input) ::posix_spawn_file_actions_adddup2(&actions, *streams.input, STDIN_FILENO);
  if (streams.output) ::posix_spawn_file_actions_adddup2(&actions, *streams.output, STDOUT_FILENO);
  const std::vector<char*> arguments = as_argv(command);
  posix_spawnattr_t attributes;
  sigset_t waiting;
  ::sigemptyset(&waiting);
  if (held) ::sigaddset(&waiting, *held);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setsigmask(&attributes, &waiting);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOMEM) throw std::bad_alloc();
  if (error != 0) throw IoError(fmt::format("{} cannot be started: {}", program, std::strerror(error)));
  return process;
}

}  // namespace

std::filesystem::path sibling(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

void become_sibling(const std::string& name, std::vector<std::string> arguments) {
  const std::filesystem::path program = sibling(name);
  arguments.insert(arguments.begin(), program.string());
  ::execv(program.c_str(), as_argv(arguments).data());
  if (errno == ENOMEM) throw std::bad_alloc();
  throw IoError(fmt::format("{} cannot be started: {}", program.string(), std::strerror(errno)));
}

bool run_child(std::vector<std::string> command, const ChildStreams& streams) {
  const std::string program = command.front();
  const pid_t process = start(program, std::move(command), streams, std::nullopt);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

ChildEnd run_child_until(const std::atomic<bool>& stop, const std::filesystem::path& program,
                         std::vector<std::string> command, const ChildStreams& streams) {
  const pid_t process = start(program.string(), std::move(command), streams, SIGINT);
  bool told = false;
  int status = 0;
  while (::waitpid(process, &status, WNOHANG) == 0) {
    if (stop && !told) {
      ::kill(process, SIGTERM);
      told = true;
    }
    std::this_thread::sleep_for(patience);
  }
  if (WIFSIGNALED(status)) return {WTERMSIG(status), true};
  return {WEXITSTATUS(status), false};
}

}  // namespace rubsweep::apps
