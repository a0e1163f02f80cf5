#include "program.hpp"

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

#include "exit_code.hpp"
#include "rubsweep/batch/directory.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::apps {

namespace {

/// What was printed may still be on its way to a full disk or a closed pipe.
void flush_stdout() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw std::system_error(errno, std::generic_category(), "standard output");
}

}  // namespace

void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

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

int run_program(std::string_view name, const std::function<int()>& body) {
  open_standard_descriptors();
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
    if (error.code() == std::errc::broken_pipe)
      return 128 + SIGPIPE;  // nobody reads on: as if it had ended us
    complain(error);
    return input_output;
  } catch (const std::bad_alloc&) {
    say(fmt::format("{}: out of memory\n", name));
    return software_fault;
  } catch (const std::exception& error) {
    complain(error);
    return software_fault;
  }
}

void make_directory(const std::filesystem::path& directory) { batch::make_directory(directory); }

}  // namespace rubsweep::apps
