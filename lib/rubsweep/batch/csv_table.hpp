#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::batch {

/// The shortest text that reads back to the same double; empty for NaN (does not apply), "inf" and "-inf".
std::string csv_number(double value);

/// One line without its end: cells joined by commas, quoted (RFC 4180) only where they would read back
/// otherwise.
std::string csv_row(std::span<const std::string> cells);

/// A table as read from a file: every row has as many cells as the header.
struct CsvTable {
  std::filesystem::path path;
  std::vector<std::string> comments;  ///< lines that start with '#', without it and one blank after it
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> lines;  ///< line of the file where each row starts, from 1
};

/// Reads a comma-separated table: comment lines anywhere, then a header of distinct names, then rows. Cells
/// stay text, blanks included; empty lines are skipped. Throws IoError, with file:line where the text is at
/// fault.
CsvTable read_csv(const std::filesystem::path& path);

/// Place of the column called `name`. Throws IoError naming the file and its columns when there is none.
std::size_t column(const CsvTable& table, std::string_view name);

/// The number in one cell; NaN when it is empty. Throws IoError with file:line when it is no number.
double number(const CsvTable& table, std::size_t row, std::size_t column);

}  // namespace rubsweep::batch
