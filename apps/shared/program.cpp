#include "shared/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {

namespace {

/// "PROGRAM: TEXT", where nothing can be allocated, and in signal handlers.
void say_without_memory(std::string_view text) {
  for (const std::string_view part : {std::string_view(program_invocation_short_name), std::string_view(": "),
                                      text, std::string_view("\n")})
    (void)!::write(STDERR_FILENO, part.data(), part.size());
}

/// An abort is the end of a library that finds no memory (FFTW), and of an exception that nobody catches.
/// Finished cells are in the journals, and the system frees the locks.
void end_after_abort(int) {
  say_without_memory("ended by an abort: out of memory, or a fault of the program");
  ::_exit(software_fault);
}

/// Runs before all other initialisation, which needs memory as well.
[[gnu::constructor(101)]] void expect_aborts() { std::signal(SIGABRT, end_after_abort); }

/// Printed text may still be on its way to a full disk or a closed pipe.
void flush_stdout() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::system_error(errno, std::generic_category(), "standard output");
}

}  // namespace

void print_text(const std::string& text) {
  const std::string shown = config::yaml::printable(text);
  std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void ask(std::string_view program, const std::vector<std::string>& questions, bool quiet) {
  if (quiet) return;
  for (const std::string& question : questions) say(fmt::format("{}: question: {}\n", program, question));
}

void open_standard_descriptors() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The smallest free number is the one that is closed. Opened the other way round, it still cannot be
    // used.
    if (::fcntl(number, F_GETFD) < 0 && errno == EBADF)
      (void)!::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

namespace {

int run_guarded(std::string_view name, const std::function<int()>& body) {
  open_standard_descriptors();
  end_on_interrupts("");
  // A file-size limit is then an error of the write that met it, with its message, instead of a silent death.
  std::signal(SIGXFSZ, SIG_IGN);
  // So is a reader of the progress who has gone, which must not end a sweep.
  std::signal(SIGPIPE, SIG_IGN);
  const auto complain = [name](const std::exception& error) {
    say(fmt::format("{}: {}\n", name, error.what()));
  };
  try {
    const int code = body();
    flush_stdout();
    return code;
  } catch (const UsageError& error) {
    say(fmt::format("{0}: {1}\nTry: {0} --help\n", name, error.what()));
    return usage;
  } catch (const ConfigError& error) {
    // Already one line per problem, each with its place.
    say(fmt::format("{}\n", error.what()));
    return bad_configuration;
  } catch (const IoError& error) {
    complain(error);
    return input_output;
  } catch (const LockedError& error) {
    complain(error);
    return directory_in_use;
  } catch (const std::system_error& error) {  // the file system's and {fmt}'s
    if (error.code() == std::errc::not_enough_memory) throw std::bad_alloc();
    if (error.code() == std::errc::broken_pipe)
      return 128 + SIGPIPE;  // nobody reads on: as if it had ended us
    complain(error);
    return input_output;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    complain(error);
    return software_fault;
  }
}

/// Adds the summary where one is wanted.
int summarised(std::string_view name, int code) {
  if (!summary_is_wanted()) return code;
  return run_guarded(name, [&] {
    print_summary(name, code);
    return code;
  });
}

}  // namespace

int run_program(std::string_view name, const std::function<int()>& body) {
  try {
    return summarised(name, run_guarded(name, body));
  } catch (...) {  // no memory, perhaps not even for the message about something else
    say_without_memory("out of memory");
    return software_fault;
  }
}

}  // namespace rubsweep::apps
