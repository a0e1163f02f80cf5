#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::table {

/// Text of a file in UTF-8 without its byte order mark. Recognised are UTF-8, UTF-16 (with a mark, or where
/// every second byte at the begin is zero), and otherwise Latin-1, in which spreadsheets of Windows write the
/// sign for micro. Throws Fault for bytes that are no text.
std::string utf8_of(std::string_view bytes);

/// Reads the rows of a table one after another, without comments and blank lines. The decimal sign is a point
/// or, where commas do not separate the cells, a comma; it must be the same in the whole table.
class Rows {
 public:
  Rows(std::string_view text, const Layout& layout);

  /// Goes to the next row; false at the end. Throws Fault for a row with too few cells, or with more cells
  /// than columns.
  bool next();
  /// Like next(), but skips lines that have only words.
  bool next_reading();

  const std::vector<std::string_view>& cells() const { return cells_; }  ///< at least fewest_cells of them
  std::size_t line() const { return line_; }                             ///< line number, from 1
  bool is_empty() const;                                                 ///< true: all cells are empty

  bool is_number(std::size_t column) const;  ///< true for a number in either notation; an empty cell is none
  std::size_t place_of(std::size_t column) const;  ///< byte at which a cell begins in its line, from 1
  /// Number in a cell; NaN for an empty cell. Throws Fault where the cell holds something else.
  double number(std::size_t column);
  /// Like number(), but also NaN for a word that instruments write for a reading out of range.
  double reading(std::size_t column);
  /// Seconds of the time stamp in a cell. Throws Fault where the cell is no time stamp.
  double time_stamp(std::size_t column);
  /// line numbers of the skipped lines of words
  const std::vector<std::size_t>& notes() const { return notes_; }
  /// Place of a cell, and what is wrong with it.
  Fault fault(std::size_t column, const std::string& wrong, const std::string& allowed) const;

 private:
  /// Reads the cells of the next line that is no comment and not blank; false where there is none.
  bool read_line();
  /// Throws Fault for a line with too few or too many cells; otherwise returns true.
  bool take_cells();
  /// Notes which decimal sign a cell has.
  void look_at(std::string_view cell, std::size_t column);

  const Layout& layout_;
  std::string_view rest_, text_;
  NumberStyle style_;
  std::size_t next_line_, line_ = 0, first_line_ = 0, point_line_ = 0;
  std::vector<std::string_view> cells_;
  std::vector<std::size_t> notes_;
};

}  // namespace rubsweep::table
