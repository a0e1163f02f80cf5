#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::table {

/// Notation of the numbers in a table.
struct NumberStyle {
  char separator = ',';
  bool decimal_comma = false;
};

/// Problem of a text, with its place.
struct Fault {
  std::size_t line = 1, column = 1;
  std::string wrong, allowed;
};

/// Cells of a line, without blanks and quotes around them. For the separator ' ' any number of blanks
/// separates.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// Number in a cell; NaN for an empty cell or the text NaN; empty for any other text, infinity included.
/// Exponents have an e, or a d and a sign as in Fortran.
std::optional<double> number_in(std::string_view cell, const NumberStyle& style);

/// Time of a time stamp in s: since midnight, or since an epoch where a date (year-month-day or
/// day.month.year) and a blank or T come first. Empty where the cell is no time stamp.
std::optional<double> time_stamp_in(std::string_view cell, const NumberStyle& style);

/// Heading of a column.
struct Heading {
  std::string name{}, unit{};  ///< name and unit, the unit without brackets
};

/// Splits "name (unit)" or "name [unit]".
Heading heading_of(std::string_view cell);

/// Unit without blanks and signs between its parts: "N-s/m", "N s/m" and "N·s/m" all become "Ns/m", and both
/// signs for micro become u.
std::string plain_unit(std::string_view unit);

/// Whether a cell holds only a unit: a known one, or anything in brackets.
bool is_unit(std::string_view cell);

/// Text in small letters. Only ASCII letters change.
std::string in_small_letters(std::string_view text);

}  // namespace rubsweep::table
