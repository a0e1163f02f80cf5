#include "result_files.hpp"

#include <fmt/format.h>

#include "rubsweep/batch/whole_file.hpp"

namespace rubsweep::apps {

namespace fs = std::filesystem;

void write_result_files(const ResultFiles& files, std::span<const std::string_view> names,
                        const fs::path& directory) {
  for (const std::string_view name : names) {
    const auto file = files.find(name);
    if (file == files.end()) {
      fs::remove(directory / name);
    } else {
      batch::write_whole_file(directory / name, file->second);
    }
  }
}

std::string files_line(const ResultFiles& files, const fs::path& directory) {
  std::string names;
  for (const auto& [name, text] : files) names.append(" ").append(name);
  return fmt::format("files     {}:{}\n", directory.string(), names);
}

fs::path directory_beside(const fs::path& map, std::string_view ending) {
  fs::path directory = map.has_filename() ? map : map.parent_path();
  return directory += ending;
}

}  // namespace rubsweep::apps
