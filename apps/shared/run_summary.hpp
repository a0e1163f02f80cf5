#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// One line of JSON at the end of a run, for scripts: --summary json.
namespace rubsweep::apps {

/// Asks for the line; time counts from the start of the program in any case.
void want_summary();
bool summary_is_wanted();

/// Holds the line back at the end of a part of a program, or no longer.
void hold_summary(bool held);

/// A number of the summary's `counts`, such as "cells"; the last one of a name counts. Nothing is done where
/// no summary is wanted.
void count_in_summary(const std::string& name, std::size_t number);

/// Takes over what a child says it did, as if it had been done here: its counts, messages and files.
/// `printed` is what it printed on standard output; returned without its summary.
std::string take_summary(std::string printed);

/// Prints {"program", "version", "exit_code", "seconds", "counts", "warnings", "messages", "files"} on one
/// line of standard output. `warnings` are warnings and questions, `messages` the other lines of standard
/// error (errors among them), `files` those that were written and are there, as absolute paths.
void print_summary(std::string_view program, int exit_code);

}  // namespace rubsweep::apps
