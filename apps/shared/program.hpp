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

/// The command line cannot be understood; programs exit with 1.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Runs a program's `body` and returns its exit code. An exception becomes a message on stderr and the exit
/// code of its cause. Until catch_interrupts is called, SIGINT and SIGTERM end the program as
/// end_on_interrupts says.
int run_program(std::string_view name, const std::function<int()>& body);

using config::yaml::say;

/// The same as say, on stdout.
void print_text(const std::string& text);
template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  print_text(fmt::format(format, std::forward<Arguments>(arguments)...));
}

/// Prints questions about numbers that are accepted as they are, a line each; nothing with `quiet`.
void ask(std::string_view program, const std::vector<std::string>& questions, bool quiet);

/// Opens /dev/null where standard input, output or error were closed, so that no data file gets their numbers
/// and with them the printed text. Such an output still reports that it cannot be written. The first thing a
/// program does; run_program does it as well.
void open_standard_descriptors();

}  // namespace rubsweep::apps
