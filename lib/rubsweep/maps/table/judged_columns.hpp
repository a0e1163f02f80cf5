#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::table {

inline constexpr std::array<char, 4> separators{'\t', ';', ',', ' '};

struct Line {
  std::string_view text;
  std::size_t number = 0, offset = 0;
};

/// Reads those lines of a text that are not blank, a number of lines at a time.
class Lines {
 public:
  explicit Lines(std::string_view text) : begin_(text.data()), rest_(text) {}

  /// Reads the next lines, and keeps the last ones read before; false at the end of the text. Drops the lines
  /// of a LabVIEW header, which precede the table.
  bool read_on(std::vector<Line>& lines);

 private:
  const char* begin_;
  std::string_view rest_;
  std::size_t number_ = 1;
};

/// Whether a cell is a number, with decimal point or decimal comma, or a time stamp.
bool is_number(std::string_view cell, char separator);

std::vector<bool> numbers_in(const std::vector<std::string_view>& cells, char separator);

/// The separator by which most lines have two numbers; a comma may also be the decimal sign. Blanks also
/// occur in words: they are the separator where clearly more lines have numbers by blanks than by any other
/// separator.
char separator_of(const std::vector<Line>& lines);

/// Finds the number of cells in a row, and the columns that hold numbers. A line has the square of its number
/// of numbers as weight, so that few rows outweigh a header of keys and values. Throws Fault for lines
/// without numbers.
void judge_columns(const std::vector<Line>& lines, Layout& layout);

/// Whether a line is a row of numbers, of which at least half are present.
bool is_row(const Line& line, const Layout& layout);

}  // namespace rubsweep::table
