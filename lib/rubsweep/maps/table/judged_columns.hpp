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

/// The lines of a text that are not blank, some at a time.
class Lines {
 public:
  explicit Lines(std::string_view text) : begin_(text.data()), rest_(text) {}

  /// The next lines, and the last of those before them; false at the end of the text. What stands above the
  /// end of a LabVIEW head is left out: the table comes behind it.
  bool read_on(std::vector<Line>& lines);

 private:
  const char* begin_;
  std::string_view rest_;
  std::size_t number_ = 1;
};

/// Whether a cell is a number in either writing, or a time stamp.
bool is_number(std::string_view cell, char separator);

std::vector<bool> numbers_in(const std::vector<std::string_view>& cells, char separator);

/// The separator that most lines have two numbers by; a comma may also be that of decimals. Blanks stand in
/// words, too: they part the cells where most lines have numbers by them, and clearly more than by another.
char separator_of(const std::vector<Line>& lines);

/// Cells of a row, and which of its columns hold numbers; lines count by the square of how many numbers they
/// have, so that a head of keys and values is outdone by few rows. Throws Fault for lines without numbers.
void judge_columns(const std::vector<Line>& lines, Layout& layout);

/// Whether a line is a row of numbers, at least half of which are there.
bool is_row(const Line& line, const Layout& layout);

}  // namespace rubsweep::table
