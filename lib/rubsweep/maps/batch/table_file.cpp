#include "rubsweep/maps/batch/table_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <variant>

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view sum_mark = "# sha256 ", format_mark = "# format ";
constexpr std::size_t digits_of_sum = 64;
constexpr std::string_view growing_ending = ".partial.csv";

std::string sum_line(std::string_view digits) { return fmt::format("{}{}\n", sum_mark, digits); }

/// Computes the checksum of all lines except the checksum line, and collects what the comments at the begin
/// say. No row begins with '#'.
class TableCheck {
 public:
  void add(std::string_view line) {
    if (first_) ends_in_cr_lf_ = line.ends_with("\r\n");
    first_ = false;
    ends_ = line.ends_with('\n');
    const bool carriage_return = ends_in_cr_lf_ && line.ends_with("\r\n");
    line.remove_suffix(carriage_return ? 2 : ends_ ? 1 : 0);
    if (!said_ && line.starts_with(sum_mark)) {
      said_ = line.substr(sum_mark.size());
      return;
    }
    if (!format_ && line.starts_with(format_mark)) {
      int format = 0;
      const char* end = line.data() + line.size();
      const bool number = std::from_chars(line.data() + format_mark.size(), end, format).ec == std::errc();
      if (number || line.size() == format_mark.size()) format_ = format;
    }
    sum_.add(line);
    if (ends_) sum_.add("\n");
  }

  TableSum verdict(const fs::path& path) {
    const auto refuse = [&](const std::string& why) {
      throw DamagedTable(fmt::format("{}: is not as it was written: {}", path.string(), why));
    };
    if (format_ && *format_ > table_format) {
      throw IoError(fmt::format("{}: is a table of format {}, allowed: those up to {}, or a later program",
                                path.string(), *format_, table_format));
    }
    if (!said_ && (!format_ || path.native().ends_with(growing_ending))) return TableSum::none;
    if (!said_) refuse("its checksum is missing");
    if (const std::string found = sum_.digits(); found != *said_) {
      refuse(fmt::format("{}its sha256 is {}, not {}", ends_ ? "" : "its last line has no end, ", found,
                         *said_));
    }
    return TableSum::right;
  }

 private:
  Sha256 sum_;
  std::optional<std::string> said_;  ///< checksum that the table itself gives
  std::optional<int> format_;
  bool first_ = true;
  bool ends_ = true;  ///< true: the text ends with a line end
  bool ends_in_cr_lf_ =
      false;  ///< true: lines end in CR LF, as programs of other systems write them; the numbers are the same
};

}  // namespace

std::string table_head(const TableSource& source) {
  std::string head =
      fmt::format("# {}\n# digest {}\n{}{}\n", source.program, source.digest, format_mark, table_format);
  if (!source.files.empty()) head += fmt::format("# files {}\n", fmt::join(source.files, " "));
  for (const auto& [name, digits] : source.sums) head += fmt::format("# sum {} {}\n", name, digits);
  return head + source.captions;
}

TableFile::TableFile(fs::path path, const TableSource& source) : file_(std::move(path)) {
  write(table_head(source));
  place_of_sum_ = table_head(source).size() + sum_mark.size();
  file_.write(sum_line(std::string(digits_of_sum, '0')));
}

void TableFile::write(std::string_view text) {
  sum_.add(text);
  file_.write(text);
}

void TableFile::finish() {
  if (std::exchange(finished_, true)) return;
  file_.write_at(place_of_sum_, sum_.digits());
  file_.finish();
}

void TableFile::commit() {
  finish();
  file_.commit();
}

void TableFile::rename() {
  finish();
  file_.rename();
}

TableSum check_table(const fs::path& path) {
  InputLines lines(path);
  return check_table(lines, path);
}

TableSum check_table(InputLines& lines, const fs::path& path) {
  TableCheck check;
  for (std::string_view line = lines.next(); !line.empty(); line = lines.next()) check.add(line);
  lines.go_to(0);
  return check.verdict(path);
}

TableSum check_table_text(std::string_view text, const fs::path& path) {
  TableCheck check;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n')), whole = text.substr(0, line.size() + 1);
    check.add(whole);
    text.remove_prefix(whole.size());
  }
  return check.verdict(path);
}

std::string caption_lines(const Captions& captions) {
  std::string lines;
  const auto add = [&](const char* name, const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      lines.append("# ").append(name);
      if (!line.empty()) lines.append(" ").append(line);
      lines.append("\n");
    }
  };
  add("title", captions.title);
  add("author", captions.author);
  add("note", captions.note);
  return lines;
}

namespace {

TableSource table_source(const ResultSource& source) {
  return {fmt::format("{} {}", source.program, RUBSWEEP_VERSION), source.digest, {}, source.captions};
}

/// Whether a file is a table, which contains its own checksum.
bool is_table(const fs::path& name) { return name.extension() == ".csv"; }

/// File that is complete on the disk but does not have its final name yet.
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
  // A symbolic link stays; the file to which it leads is replaced.
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
