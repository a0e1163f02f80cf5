#include "rubsweep/batch/table_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <optional>
#include <utility>

#include "rubsweep/batch/input_file.hpp"

namespace rubsweep::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view sum_mark = "# sha256 ", format_mark = "# format ";
constexpr std::size_t digits_of_sum = 64;

std::string sum_line(std::string_view digits) { return fmt::format("{}{}\n", sum_mark, digits); }

/// Facts about a table that decide whether it is whole.
struct Reading {
  Sha256 sum;
  std::optional<std::string> said;  ///< by the line of the sum
  std::optional<int> format;
  bool ends = true;  ///< with the end of a line
};

/// No row begins with '#'.
Reading read_table(const fs::path& path) {
  const InputStream file = open_input_stream(path);
  LineBuffer buffer;
  Reading reading;
  while (true) {
    const std::string_view line = read_line(file.get(), path, buffer.text, buffer.capacity);
    if (line.empty()) return reading;
    reading.ends = line.ends_with('\n');
    if (!reading.said && line.starts_with(sum_mark)) {
      reading.said = line.substr(sum_mark.size(), line.size() - sum_mark.size() - (reading.ends ? 1 : 0));
      continue;
    }
    if (!reading.format && line.starts_with(format_mark)) {
      int format = 0;
      std::from_chars(line.data() + format_mark.size(), line.data() + line.size(), format);
      reading.format = format;
    }
    reading.sum.add(line);
  }
}

}  // namespace

std::string table_head(const TableSource& source) {
  return fmt::format(
      "# {}\n# digest {}\n{}{}\n{}{}", source.program, source.digest, format_mark, table_format,
      source.files.empty() ? "" : fmt::format("# files {}\n", fmt::join(source.files, " ")), source.captions);
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
  Reading reading = read_table(path);
  const auto refuse = [&](const std::string& why) {
    throw DamagedTable(fmt::format("{}: is not as it was written: {}", path.string(), why));
  };
  if (reading.format && *reading.format > table_format) {
    throw IoError(fmt::format("{}: is a table of format {}, allowed: those up to {}, or a later program",
                              path.string(), *reading.format, table_format));
  }
  if (!reading.said && !reading.format) return TableSum::none;
  if (!reading.said) refuse("its checksum is missing");
  if (const std::string found = reading.sum.digits(); found != *reading.said) {
    refuse(fmt::format("{}its sha256 is {}, not {}", reading.ends ? "" : "its last line has no end, ", found,
                       *reading.said));
  }
  return TableSum::right;
}

}  // namespace rubsweep::batch
