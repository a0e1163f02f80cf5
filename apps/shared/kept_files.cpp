#include "shared/kept_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

bool is_written_by_a_program(const fs::path& file, const std::function<std::string()>& written) {
  try {
    return config::yaml::read_config_bytes(file) == written();
    // the file is incomplete without the command line, so none of these programs wrote it
  } catch (const ConfigError&) {
    return false;
  }
}

/// Whether a directory holds a map, a part of one, or an unfinished one.
bool holds_a_map(const fs::path& directory) {
  if (!fs::is_directory(directory)) return false;
  return std::ranges::any_of(fs::directory_iterator(directory), [](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename();
    return name == "map.csv" || (name.starts_with("map.") && name.ends_with(".journal"));
  });
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

fs::path results_directory(const StudyArguments& arguments, const fs::path& of_map, std::string_view ending) {
  fs::path directory = arguments.output.value_or(batch::directory_beside(of_map, ending));
  keep_run_configuration(arguments.config, directory);
  if (holds_a_map(directory)) {
    throw ConfigError(
        fmt::format("{}: holds a map, whose config.yaml would be replaced, allowed: another --output",
                    directory.string()));
  }
  return directory;
}

}  // namespace rubsweep::apps
