#include "kept_files.hpp"

#include <fmt/format.h>

#include <system_error>

#include "rubsweep/config/file.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

bool is_written_by_a_program(const fs::path& file, const std::function<std::string()>& written) {
  try {
    return config::read_config_bytes(file) == written();
  } catch (const ConfigError&) {  // needs what the command line adds
    return false;
  }
}

}  // namespace

void keep_configuration(const fs::path& file, const fs::path& directory,
                        const std::function<std::string()>& written) {
  std::error_code none;
  if (!fs::equivalent(file, directory / "config.yaml", none) || is_written_by_a_program(file, written))
    return;
  throw ConfigError(
      fmt::format("{}: would be replaced by the config.yaml of the results, allowed: another name for this "
                  "file, or another directory for the results",
                  file.string()));
}

void keep_run_configuration(const fs::path& file, const fs::path& directory) {
  keep_configuration(file, directory,
                     [&] { return config::print_config(config::read_run_config(file, {})); });
}

void keep_map(const fs::path& directory) {
  if (!fs::exists(directory / "map.csv") && !fs::exists(directory / "map.journal")) return;
  throw ConfigError(
      fmt::format("{}: holds a map, whose config.yaml would be replaced, allowed: another "
                  "--output",
                  directory.string()));
}

}  // namespace rubsweep::apps
