#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::table {

/// Text of a file as UTF-8 without a byte order mark. The file may be UTF-8, UTF-16 with a mark, or else
/// Latin-1, in which spreadsheets of Windows write the sign for micro. Throws Fault for bytes that are no
/// text.
std::string utf8_of(std::string_view bytes);

/// Reads the rows of a table one after the other, without comments and blank lines. Decimals have a point or,
/// where commas do not separate the cells, a comma; all of the table must use the same sign.
class Rows {
 public:
  Rows(std::string_view text, const Layout& layout);

  /// Goes to the next row; false at the end. Throws Fault for a row with too few cells, or with more cells
  /// than columns.
  bool next();

  const std::vector<std::string_view>& cells() const { return cells_; }  ///< at least fewest_cells of them
  std::size_t line() const { return line_; }                             ///< line number, from 1
  bool is_empty() const;                                                 ///< true: all cells are empty

  bool is_number(std::size_t column) const;  ///< true for a number in either notation; an empty cell is none
  std::size_t place_of(std::size_t column) const;  ///< byte at which a cell begins in its line, from 1
  /// Number in a cell; NaN for an empty cell. Throws Fault where the cell holds no number.
  double number(std::size_t column);
  /// Seconds of the time stamp in the first cell. Throws Fault where the cell holds none.
  double time_stamp();
  bool begins_with_stamp() const;
  /// Problem of a cell, with its place.
  Fault fault(std::size_t column, const std::string& wrong, const std::string& allowed) const;

 private:
  /// Records which decimal sign is used.
  void look_at(std::string_view cell, std::size_t column);

  const Layout& layout_;
  std::string_view rest_, text_;
  NumberStyle style_;
  std::size_t next_line_, line_ = 0, first_line_ = 0, point_line_ = 0;
  std::vector<std::string_view> cells_;
};

}  // namespace rubsweep::table
