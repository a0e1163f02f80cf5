#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {

/// A column of a table.
struct Column {
  Heading heading;            ///< heading; its name is empty where the table gives none
  std::size_t column = 1;     ///< first byte of its name in the line, counted from 1
  bool is_text = false;       ///< true: cells are words, such as a comment or a status, and not numbers
  std::size_t text_line = 0;  ///< line of one such cell
  bool is_stamp = false;      ///< true: cells are time stamps
  bool is_empty = false;      ///< true: none of the first lines has a cell there
};

/// Layout of a table, found from its first lines.
struct Layout {
  char separator = ',';
  std::vector<Column> columns;
  std::size_t names_line = 0;      ///< line number from 1; 0: the table has no names
  std::size_t numbers_offset = 0;  ///< place of the first number
  std::size_t numbers_line = 1;    ///< line of the first numbers, counted from 1
  std::size_t fewest_cells = 1;    ///< smallest number of cells in a row: up to its last column of numbers
  bool head_beside = false;        ///< keys and values stand beside the first rows
};

/// Removes the first line from a text and returns it; a line ends with LF, CR LF or CR.
std::string_view take_line(std::string_view& text);

/// Whether a line is blank or begins with # or %.
bool is_comment(std::string_view line);

/// Layout of a table of numbers in UTF-8. The numbers begin in the first line with the layout that most lines
/// of numbers have. Lines of units may stand above it. The names are the nearest line above with a different
/// name for each column, none of them a number or a unit; above units it may also be a line that numbers the
/// columns. A comment is used where there is no other line. Keys and values may also stand beside the first
/// rows. Throws Fault for a text without numbers.
Layout layout_of(std::string_view text);

/// Finds the layout of a table by a line of names, some of which `is_name` knows. The table begins with this
/// line, and every cell may be text. Throws Fault where no name is known.
Layout layout_of(std::string_view text, const std::function<bool(const Heading&)>& is_name);

}  // namespace rubsweep::table
