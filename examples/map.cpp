// Computes the map of a configuration in a directory, like the program rubsweep, and prints what it contains.
//
//     map CONFIG DIRECTORY
//
// Ctrl-C keeps the finished cells; the same command computes the others.

#include "rubsweep/map.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "rubsweep/configuration.hpp"
#include "rubsweep/error.hpp"

namespace {

using namespace rubsweep;

std::atomic<bool> stop = false;

int make_map(const std::filesystem::path& file, const std::filesystem::path& directory) {
  // An override works like `--set` of the programs: it changes one number of the configuration.
  const config::RunConfig config = config::read_run_config(file, {"kick.force_n=250"});
  std::printf("%zu cells\n", sweep::cell_count(config.study.grid));

  const auto summary = map::compute(
      config, directory, {.stop = &stop, .progress = batch::ProgressMode::automatic, .program = "map"});
  if (!summary) {
    std::puts("stopped; the same command computes the other cells");
    return 130;
  }
  std::printf("%s%s\n", summary->text().c_str(), (directory / "map.csv").c_str());
  return summary->has_failed_cells() ? 4 : 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: map CONFIG DIRECTORY\n", stderr);
    return 1;
  }
  std::signal(SIGINT, [](int) { stop = true; });
  try {
    return make_map(arguments[1], arguments[2]);
  } catch (const rubsweep::ConfigError& error) {  // contains every problem of the file, one per line
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "map: %s\n", error.what());
    return 3;
  }
}
