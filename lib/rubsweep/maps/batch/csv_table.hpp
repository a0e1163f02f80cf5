#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/opened_file.hpp"

namespace rubsweep::batch {

/// Shortest text that reads back to the same double; empty for NaN, which means "does not apply"; "inf" and
/// "-inf".
std::string csv_number(double value);

/// One line without its end: cells joined by commas. A cell is quoted (RFC 4180) only where it would not read
/// back otherwise.
std::string csv_row(std::span<const std::string> cells);

/// Reads a comma-separated file row by row: comment lines anywhere, a header of distinct names, then rows
/// with as many cells. Cells stay text, blanks included, and empty lines are skipped. Throws IoError, with
/// file:line for errors in the text, and DamagedTable where the table has a wrong checksum.
class CsvReader {
 public:
  /// Opens the file and reads it up to the header.
  explicit CsvReader(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& comments() const {
    return comments_;
  }  ///< comments read so far, without '#' and one blank behind it
  const std::vector<std::string>& header() const { return header_; }

  /// Position of a row in the file.
  struct RowPosition {
    std::uint64_t offset = 0;
    std::size_t line = 0;  ///< number of the line, from 1
  };

  /// Reads the next row; false when there is none.
  bool next();

  /// Reads the row at a position that place() returned earlier. `next` then continues with the following row.
  void read_at(const RowPosition& place);

  const std::vector<std::string>& cells() const { return cells_; }  ///< cells of the current row
  const RowPosition& place() const { return place_; }               ///< position of the current row

  /// Index of the column called `name`. Throws IoError with the file and its columns where it is missing.
  std::size_t column(std::string_view name) const;

  /// Number in a cell of the current row; NaN where it is empty. Throws IoError with file:line where it is no
  /// number.
  double number(std::size_t column) const;

 private:
  bool read_record();
  std::vector<std::string> parse_record() const;

  std::filesystem::path path_;
  InputLines lines_;
  RowPosition next_{0, 1};  ///< where the next line starts
  RowPosition place_;
  std::string record_;  ///< text of the row: one line, or more where a quoted cell continues
  std::vector<std::string> comments_, header_, cells_;
};

}  // namespace rubsweep::batch
