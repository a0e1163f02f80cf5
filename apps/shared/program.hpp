#pragma once

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::apps {

/// Invalid command line; programs exit with 1.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a program's `body` and returns its exit code. An exception becomes a message on stderr and the exit
/// code for its cause. Until catch_interrupts is called, SIGINT and SIGTERM end the program as in
/// end_on_interrupts.
int run_program(std::string_view name, const std::function<int()>& body);

using config::yaml::say;

/// Prints text on stdout, with control characters made visible.
void print_text(const std::string& text);
template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Prints questions about accepted but unlikely numbers, one per line; prints nothing with `quiet`.
void ask(std::string_view program, const std::vector<std::string>& questions, bool quiet);

/// Opens /dev/null where standard input, output or error is closed. Otherwise a data file could get its
/// number, and printed text would be written to that file. Writing to such an output still fails. Programs
/// call this function first; run_program calls it, too.
void open_standard_descriptors();

}  // namespace rubsweep::apps
