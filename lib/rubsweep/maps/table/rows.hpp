#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::table {

/// Text of a file in UTF-8 without its byte order mark: UTF-8, UTF-16 with a mark or where every other byte
/// of the begin is zero, or Latin-1 where it is no UTF-8, as spreadsheets of Windows write the sign for
/// micro. Throws Fault for bytes that are no text.
std::string utf8_of(std::string_view bytes);

/// Reads the rows of a table one after the other, without comments and blank lines. Decimals have a point or,
/// where commas do not separate the cells, a comma; all of the table must use the same sign.
class Rows {
 public:
  Rows(std::string_view text, const Layout& layout);

  /// Goes to the next row; false at the end. Throws Fault for a row with too few cells, or with more cells
  /// than columns.
  bool next();
  /// The same, but lines of words and nothing else are passed over.
  bool next_reading();

  const std::vector<std::string_view>& cells() const { return cells_; }  ///< at least fewest_cells of them
  std::size_t line() const { return line_; }                             ///< line number, from 1
  bool is_empty() const;                                                 ///< true: all cells are empty

  bool is_number(std::size_t column) const;  ///< true for a number in either notation; an empty cell is none
  std::size_t place_of(std::size_t column) const;  ///< byte at which a cell begins in its line, from 1
  /// Number in a cell; NaN for an empty cell. Throws Fault where the cell holds no number.
  double number(std::size_t column);
  /// The same, and NaN for a word that instruments put in the place of a reading out of their range.
  double reading(std::size_t column);
  /// Seconds of the time stamp in a cell. Throws Fault where it is none.
  double time_stamp(std::size_t column);
  const std::vector<std::size_t>& notes() const { return notes_; }  ///< lines of words that were passed over
  /// Place of a cell, and what is wrong with it.
  Fault fault(std::size_t column, const std::string& wrong, const std::string& allowed) const;

 private:
  /// Reads the cells of the next line that counts; false where there is none.
  bool read_line();
  /// Refuses a line with too few or too many cells; else true.
  bool take_cells();
  /// Takes note of how decimals are written.
  void look_at(std::string_view cell, std::size_t column);

  const Layout& layout_;
  std::string_view rest_, text_;
  NumberStyle style_;
  std::size_t next_line_, line_ = 0, first_line_ = 0, point_line_ = 0;
  std::vector<std::string_view> cells_;
  std::vector<std::size_t> notes_;
};

}  // namespace rubsweep::table
