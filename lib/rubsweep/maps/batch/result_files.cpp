#include "rubsweep/maps/batch/result_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <variant>

#include "rubsweep/maps/batch/directory.hpp"
#include "rubsweep/maps/batch/leftovers.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"

namespace rubsweep::batch {

namespace fs = std::filesystem;

namespace {

TableSource table_source(const ResultSource& source) {
  return {fmt::format("{} {}", source.program, RUBSWEEP_VERSION), source.digest, {}, source.captions};
}

/// Only tables hold their sums themselves.
bool is_table(const fs::path& name) { return name.extension() == ".csv"; }

/// A file that is whole on the disk, and has not its name yet.
using Waiting = std::variant<std::unique_ptr<TableFile>, std::unique_ptr<WholeFile>>;

Waiting waiting_file(const fs::path& path, const std::string& text, const TableSource& source) {
  const auto finished = [&](auto file) {
    file->write(text);
    file->finish();
    return file;
  };
  if (is_table(path)) return finished(std::make_unique<TableFile>(path, source));
  return finished(std::make_unique<WholeFile>(path));
}

}  // namespace

void write_result_files(const ResultFiles& files, std::span<const std::string_view> names,
                        const fs::path& directory, const ResultSource& source) {
  TableSource table = table_source(source);
  for (const auto& [name, text] : files) {
    table.files.emplace_back(name);
    if (!is_table(name)) table.sums.emplace_back(name, sha256_of(text));
  }
  table.files.insert(table.files.end(), source.made_of.begin(), source.made_of.end());
  std::vector<Waiting> waiting;
  for (const auto& [name, text] : files) waiting.push_back(waiting_file(directory / name, text, table));
  // A link stays: the file behind it is replaced.
  for (const auto& [name, text] : files) fs::remove(file_behind(directory / name));
  std::vector<std::string_view> others(names.begin(), names.end());
  std::erase_if(others, [&](std::string_view name) { return files.contains(name); });
  remove_result_files(others, directory);
  for (Waiting& file : waiting) std::visit([](auto& whole) { whole->rename(); }, file);
  sync_directory(directory);
}

void remove_result_files(std::span<const std::string_view> names, const fs::path& directory) {
  remove_leftovers(directory,
                   [&](std::string_view name) { return std::ranges::find(names, name) != names.end(); });
  for (const std::string_view name : names) fs::remove(directory / name);
  sync_directory(directory);
}

std::string growing_table_head(const ResultSource& source) { return table_head(table_source(source)); }

std::string files_line(const ResultFiles& files, const fs::path& directory) {
  std::string names;
  for (const auto& [name, text] : files) names.append(" ").append(name);
  return fmt::format("files     {}:{}\n", directory.string(), names);
}

fs::path directory_beside(const fs::path& map, std::string_view ending) {
  fs::path directory = map.has_filename() ? map : map.parent_path();
  return directory += ending;
}

}  // namespace rubsweep::batch
