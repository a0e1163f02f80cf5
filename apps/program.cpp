#include "program.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "exit_code.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::apps {

int run_program(std::string_view name, const std::function<int()>& body) {
  const auto complain = [name](const std::exception& error) { fmt::print(stderr, "{}: {}\n", name, error.what()); };
  try {
    return body();
  } catch (const UsageError& error) {
    fmt::print(stderr, "{0}: {1}\nTry: {0} --help\n", name, error.what());
    return usage;
  } catch (const ConfigError& error) {
    // Already one line per problem, each with its place.
    fmt::print(stderr, "{}\n", error.what());
    return bad_configuration;
  } catch (const IoError& error) {
    complain(error);
    return input_output;
  } catch (const std::filesystem::filesystem_error& error) {
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
