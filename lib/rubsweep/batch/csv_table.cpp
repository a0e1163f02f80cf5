#include "rubsweep/batch/csv_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::batch {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, std::size_t line, std::string_view message) {
  throw IoError(fmt::format("{}:{}: {}", path.string(), line, message));
}

/// The text of a file and how far it is read.
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

std::string read_comment(Cursor& cursor) {
  cursor.take(cursor.rest.starts_with("# ") ? 2 : 1);
  std::string comment = cursor.take(std::min(cursor.rest.find('\n'), cursor.rest.size()));
  if (comment.ends_with('\r')) comment.pop_back();
  cursor.skip_line_end();
  return comment;
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

CsvTable read_csv(const std::filesystem::path& path) {
  CsvTable table{.path = path, .comments = {}, .header = {}, .rows = {}, .lines = {}};
  const std::string text = read_whole_file(path);
  Cursor cursor{.path = path, .rest = text};
  while (!cursor.rest.empty()) {
    const std::size_t line = cursor.line;
    if (cursor.at_line_end()) {
      cursor.skip_line_end();
    } else if (cursor.rest.starts_with('#')) {
      table.comments.push_back(read_comment(cursor));
    } else if (table.header.empty()) {
      table.header = read_row(cursor);
      require_distinct(table.header, path, line);
    } else {
      table.rows.push_back(read_row(cursor));
      table.lines.push_back(line);
      if (table.rows.back().size() != table.header.size()) {
        fail(path, line,
             fmt::format("{} cells, but the header has {}", table.rows.back().size(), table.header.size()));
      }
    }
  }
  if (table.header.empty()) fail(path, cursor.line, "no header line");
  return table;
}

std::size_t column(const CsvTable& table, std::string_view name) {
  const auto place = std::ranges::find(table.header, name);
  if (place == table.header.end()) {
    throw IoError(fmt::format("{}: no column '{}', there are: {}", table.path.string(), name,
                              fmt::join(table.header, ", ")));
  }
  return static_cast<std::size_t>(place - table.header.begin());
}

double number(const CsvTable& table, std::size_t row, std::size_t column) {
  const std::string& cell = table.rows.at(row).at(column);
  double value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return value;
  const char* end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) {
    fail(table.path, table.lines.at(row),
         fmt::format("{}: '{}' is not a number", table.header.at(column), cell));
  }
  return value;
}

}  // namespace rubsweep::batch
