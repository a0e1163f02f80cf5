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

/// The shortest text that reads back to the same double; empty for NaN (does not apply), "inf" and "-inf".
std::string csv_number(double value);

/// One line without its end: cells joined by commas, quoted (RFC 4180) only where they would read back
/// otherwise.
std::string csv_row(std::span<const std::string> cells);

/// A comma-separated file, a row at a time: comment lines anywhere, then a header of distinct names, then
/// rows of as many cells. Cells stay text, blanks included; empty lines are skipped. Throws IoError, with
/// file:line where the text is at fault; DamagedTable where the table has a checksum that is wrong.
class CsvReader {
 public:
  /// Reads up to the header.
  explicit CsvReader(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<std::string>& comments() const {
    return comments_;
  }  ///< so far, without '#' and one blank after it
  const std::vector<std::string>& header() const { return header_; }

  /// Position of a row in the file.
  struct RowPosition {
    std::uint64_t offset = 0;
    std::size_t line = 0;  ///< number of the line, from 1
  };

  /// Reads the next row; false when there is none.
  bool next();

  /// Reads the row at `place`, the position of a row; `next` continues after it.
  void read_at(const RowPosition& place);

  const std::vector<std::string>& cells() const { return cells_; }  ///< of the row
  const RowPosition& place() const { return place_; }               ///< of the row

  /// Place of the column called `name`. Throws IoError naming the file and its columns when there is none.
  std::size_t column(std::string_view name) const;

  /// The number in one cell of the row; NaN when it is empty. Throws IoError with file:line when it is none.
  double number(std::size_t column) const;

 private:
  bool read_record();
  std::vector<std::string> parse_record() const;

  std::filesystem::path path_;
  InputLines lines_;
  RowPosition next_{0, 1};  ///< where the next line starts
  RowPosition place_;
  std::string record_;  ///< text of one line, or more where a quoted cell goes on
  std::vector<std::string> comments_, header_, cells_;
};

}  // namespace rubsweep::batch
