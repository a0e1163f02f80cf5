#include "rubsweep/maps/batch/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"

namespace rubsweep::batch {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::size_t line, std::string_view message) {
  throw IoError(fmt::format("{}:{}: {}", path.string(), line, message));
}

/// Text of a row, and the position up to which it has been read.
struct Cursor {
  const std::filesystem::path& path;
  std::string_view rest;
  std::size_t line = 1;

  bool at_line_end() const { return rest.empty() || rest.starts_with('\n') || rest.starts_with("\r\n"); }

  void skip_line_end() {
    if (rest.starts_with('\r')) rest.remove_prefix(1);
    if (!rest.empty()) rest.remove_prefix(1);
    ++line;
  }

  std::string take(std::size_t length) {
    const std::string_view taken = rest.substr(0, length);
    rest.remove_prefix(taken.size());
    line += static_cast<std::size_t>(std::ranges::count(taken, '\n'));
    return std::string(taken);
  }
};

std::string comment_of(std::string_view line) {
  line.remove_prefix(line.starts_with("# ") ? 2 : 1);
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  return std::string(line);
}

std::string read_quoted_cell(Cursor& cursor) {
  const std::size_t opened = cursor.line;
  cursor.take(1);
  std::string cell;
  while (true) {
    const std::size_t quote = cursor.rest.find('"');
    if (quote == std::string_view::npos) fail(cursor.path, opened, "a quoted cell is never closed");
    cell += cursor.take(quote);
    cursor.take(1);
    if (!cursor.rest.starts_with('"')) break;
    cell += cursor.take(1);
  }
  if (!cursor.at_line_end() && !cursor.rest.starts_with(',')) {
    fail(cursor.path, cursor.line, "text after the closing quote of a cell");
  }
  return cell;
}

std::string read_plain_cell(Cursor& cursor) {
  std::size_t length = std::min(cursor.rest.find_first_of(",\n"), cursor.rest.size());
  if (cursor.rest.substr(length).starts_with('\n') && length > 0 && cursor.rest[length - 1] == '\r') --length;
  std::string cell = cursor.take(length);
  if (cell.find('"') != std::string::npos) fail(cursor.path, cursor.line, "a quote inside an unquoted cell");
  return cell;
}

std::vector<std::string> read_row(Cursor& cursor) {
  std::vector<std::string> cells;
  while (true) {
    cells.push_back(cursor.rest.starts_with('"') ? read_quoted_cell(cursor) : read_plain_cell(cursor));
    if (!cursor.rest.starts_with(',')) break;
    cursor.take(1);
  }
  cursor.skip_line_end();
  return cells;
}

void require_distinct(const std::vector<std::string>& header, const std::filesystem::path& path,
                      std::size_t line) {
  for (auto name = header.begin(); name != header.end(); ++name) {
    if (std::find(header.begin(), name, *name) != name) {
      fail(path, line, fmt::format("two columns are called '{}'", *name));
    }
  }
}

std::size_t column_of(const std::filesystem::path& path, const std::vector<std::string>& header,
                      std::string_view name) {
  const auto place = std::ranges::find(header, name);
  if (place == header.end()) {
    throw IoError(
        fmt::format("{}: no column '{}', there are: {}", path.string(), name, fmt::join(header, ", ")));
  }
  return static_cast<std::size_t>(place - header.begin());
}

double number_of(const std::filesystem::path& path, std::size_t line, const std::string& column,
                 const std::string& cell) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return value;
  const char* end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end)
    fail(path, line, fmt::format("{}: '{}' is not a number", column, cell));
  return value;
}

/// Refuses a table with a wrong checksum before any number is read from it.
void require_as_written(InputLines& lines, const std::filesystem::path& path) {
  try {
    check_table(lines, path);
  } catch (const DamagedTable& damage) {
    throw DamagedTable(
        fmt::format("{}\nallowed: a copy of it that is whole; of one that was changed on purpose, "
                    "the same without its lines '# format' and '# sha256'",
                    damage.what()));
  }
}

}  // namespace

std::string csv_number(double value) {
  if (std::isnan(value)) return "";
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return std::string(text.data(), end);
}

std::string csv_row(std::span<const std::string> cells) {
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string& cell = cells[i];
    if (i > 0) row += ',';
    const bool as_comment = i == 0 && cell.starts_with('#');
    const bool as_empty_line = cells.size() == 1 && cell.empty();
    if (!as_comment && !as_empty_line && cell.find_first_of(",\"\r\n") == std::string::npos) {
      row += cell;
      continue;
    }
    row += '"';
    for (const char c : cell) row += c == '"' ? "\"\"" : std::string(1, c);
    row += '"';
  }
  return row;
}

CsvReader::CsvReader(std::filesystem::path path) : path_(std::move(path)), lines_(path_) {
  require_as_written(lines_, path_);
  if (!read_record()) fail(path_, next_.line, "no header line");
  header_ = parse_record();
  require_distinct(header_, path_, place_.line);
}

/// Reads the next line that is no comment and not empty; false at the end of the file.
bool CsvReader::read_record() {
  record_.clear();
  std::ptrdiff_t quotes = 0;
  while (true) {
    const std::string_view line = lines_.next();
    if (line.empty()) return !record_.empty();
    if (record_.empty()) place_ = next_;
    next_.offset += line.size();
    next_.line += 1;
    if (record_.empty() && line.starts_with('#')) {
      comments_.push_back(comment_of(line));
    } else if (!record_.empty() || (line != "\n" && line != "\r\n")) {
      record_ += line;
      quotes += std::ranges::count(line, '"');
      if (quotes % 2 == 0) return true;  // an odd number of quotes: a quoted cell continues in the next line
    }
  }
}

std::vector<std::string> CsvReader::parse_record() const {
  Cursor cursor{.path = path_, .rest = record_, .line = place_.line};
  return read_row(cursor);
}

bool CsvReader::next() {
  if (!read_record()) return false;
  cells_ = parse_record();
  if (cells_.size() != header_.size()) {
    fail(path_, place_.line, fmt::format("{} cells, but the header has {}", cells_.size(), header_.size()));
  }
  return true;
}

void CsvReader::read_at(const RowPosition& place) {
  // Maps are mostly read in order. Without a seek the buffered bytes stay valid.
  if (place.offset != next_.offset) lines_.go_to(place.offset);
  next_ = place;
  if (!next()) fail(path_, place.line, "the file has become shorter");
}

std::size_t CsvReader::column(std::string_view name) const { return column_of(path_, header_, name); }

double CsvReader::number(std::size_t column) const {
  return number_of(path_, place_.line, header_.at(column), cells_.at(column));
}

}  // namespace rubsweep::batch
