#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Prints one line of JSON at the end of a run, for scripts: --summary json.
namespace rubsweep::apps {

/// Requests the line; its time is measured from the start of the program in any case.
void want_summary();
bool summary_is_wanted();

/// Turns the printing of the line off (true) or on (false). `rubsweep-mpi` calls run_program more than once,
/// and only the last call shall print the line.
void hold_summary(bool held);

/// Sets an entry of the summary's `counts`, such as "cells"; a later call with the same name replaces it.
/// Does nothing where no summary is wanted.
void count_in_summary(const std::string& name, std::size_t number);

/// Adds the counts, messages and files of a child's summary to this one. `printed` is the child's standard
/// output; it is returned without the summary line.
std::string take_summary(std::string printed);

/// Prints {"program", "version", "exit_code", "seconds", "counts", "warnings", "messages", "files"} on one
/// line of standard output. `warnings`: warnings and questions; `messages`: the other lines of standard
/// error, including errors; `files`: absolute paths of the written files that exist.
void print_summary(std::string_view program, int exit_code);

}  // namespace rubsweep::apps
