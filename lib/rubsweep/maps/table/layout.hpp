#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {

/// A column of a table.
struct Column {
  Heading heading;            ///< heading; empty name where the table has none
  std::size_t column = 1;     ///< byte in the line at which the name begins, from 1
  bool is_text = false;       ///< true: cells hold words, such as a comment or a status
  std::size_t text_line = 0;  ///< line of the first cell that holds a word
};

/// Layout of a table, found from its first lines.
struct Layout {
  char separator = ',';
  std::vector<Column> columns;
  std::size_t names_line = 0;      ///< line number from 1; 0: the table has no names
  std::size_t numbers_offset = 0;  ///< offset of the first row of numbers, in bytes
  std::size_t numbers_line = 1;    ///< line of the first row of numbers, from 1
  std::size_t fewest_cells = 1;    ///< least number of cells in a row: up to the last column of numbers
};

/// Takes the next line off a text; a line ends with LF, CR LF or CR.
std::string_view take_line(std::string_view& text);

/// Whether a line is blank or begins with # or %.
bool is_comment(std::string_view line);

/// Finds the layout of a table of numbers in UTF-8. The length of a row is that of most lines of numbers, and
/// the rows begin at the first line of this length. Lines of units may stand above. Names are in the nearest
/// line above that has a different name for each column and no numbers or units, or in a comment if there is
/// no such line. Throws Fault for a text without numbers.
Layout layout_of(std::string_view text);

/// Finds the layout of a table by a line of names of which `is_name` knows some. The table begins with this
/// line, and every cell may be text. Throws Fault where no name is known.
Layout layout_of(std::string_view text, const std::function<bool(const Heading&)>& is_name);

}  // namespace rubsweep::table
