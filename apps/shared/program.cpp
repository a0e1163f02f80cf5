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

/// Prints "PROGRAM: TEXT" without allocating memory; also for signal handlers.
void say_without_memory(std::string_view text) {
  for (const std::string_view part : {std::string_view(program_invocation_short_name), std::string_view(": "),
                                      text, std::string_view("\n")})
    (void)!::write(STDERR_FILENO, part.data(), part.size());
}

/// Handles an abort: a library ran out of memory (FFTW), or an exception was not caught. Finished cells are
/// in the journals, and the system releases the locks.
void end_after_abort(int) {
  say_without_memory("ended by an abort: out of memory, or a fault of the program");
  ::_exit(software_fault);
}

/// Runs before all other initialisation, which may already run out of memory.
[[gnu::constructor(101)]] void expect_aborts() { std::signal(SIGABRT, end_after_abort); }

/// Writes buffered text; throws where the disk is full or the pipe is closed.
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
    // open() returns the smallest free number, which is that of the closed file. The file is opened in the
    // wrong direction, so that reading or writing still fails.
    if (::fcntl(number, F_GETFD) < 0 && errno == EBADF)
      (void)!::open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

namespace {

int run_guarded(std::string_view name, const std::function<int()>& body) {
  open_standard_descriptors();
  end_on_interrupts("");
  // If a file exceeds its size limit, the write call then fails with a message, instead of a signal that
  // kills the program.
  std::signal(SIGXFSZ, SIG_IGN);
  // The same for a closed pipe: a sweep must continue when nobody reads its progress any more.
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
    // The text already has one line per problem, each with its place.
    say(fmt::format("{}\n", error.what()));
    return bad_configuration;
  } catch (const IoError& error) {
    complain(error);
    return input_output;
  } catch (const LockedError& error) {
    complain(error);
    return directory_in_use;
  } catch (const std::system_error& error) {  // thrown by the file system or by {fmt}
    if (error.code() == std::errc::not_enough_memory) throw std::bad_alloc();
    if (error.code() == std::errc::broken_pipe)
      return 128 + SIGPIPE;  // nobody reads any more: same exit code as if the signal had ended the program
    complain(error);
    return input_output;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    complain(error);
    return software_fault;
  }
}

/// Prints the summary if one is wanted; returns the exit code.
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
  } catch (...) {  // out of memory, perhaps even for an error message
    say_without_memory("out of memory");
    return software_fault;
  }
}

}  // namespace rubsweep::apps
