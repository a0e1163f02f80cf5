#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string_view>

namespace rubsweep::apps {

/// The command line cannot be understood; programs exit with 1.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a program's `body` and returns its exit code. An exception becomes a message on stderr and the exit
/// code of its cause.
int run_program(std::string_view name, const std::function<int()>& body);

/// Creates a directory and those above it where they are missing. Throws IoError.
void make_directory(const std::filesystem::path& directory);

}  // namespace rubsweep::apps
