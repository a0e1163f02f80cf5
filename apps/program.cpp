#include "program.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <system_error>

#include "exit_code.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::apps {

namespace {

/// A message that cannot be delivered must not change how the program ends.
void say(const std::string& text) { std::fputs(text.c_str(), stderr); }

/// What was printed may still be on its way to a full disk or a closed pipe.
void flush_stdout() {
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw IoError(fmt::format("standard output: {}", std::strerror(errno)));
  }
}

}  // namespace

int run_program(std::string_view name, const std::function<int()>& body) {
  // A file-size limit is then an error of the write that met it, with its message, instead of a silent death.
  std::signal(SIGXFSZ, SIG_IGN);
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
    complain(error);
    return input_output;
  } catch (const std::exception& error) {
    complain(error);
    return 70;  // a fault of the program itself (sysexits: EX_SOFTWARE)
  }
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw IoError(fmt::format("{}: {}", directory.string(), error.message()));
}

}  // namespace rubsweep::apps
