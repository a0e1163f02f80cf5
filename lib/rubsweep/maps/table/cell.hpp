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

/// Largest number of cells in a line; a line with more cells is no table of signals.
inline constexpr std::size_t most_cells = std::size_t{1} << 16;

/// The cells of a line, at most one more than most_cells, without surrounding blanks and quotes. With the
/// separator ' ', any number of blanks separates cells.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// Number in a cell; NaN for an empty cell or the text NaN; empty for any other text, infinity included.
/// Exponents have an e, or a d and a sign as in Fortran.
std::optional<double> number_in(std::string_view cell, const NumberStyle& style);

/// Whether commas may separate thousands: groups of three digits after a first group of one to three.
bool may_part_thousands(std::string_view cell);

/// Words of a table above a column.
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

/// A text of a file fit for names and messages: control characters become question marks.
std::string printable(std::string_view text);

/// Letters of ASCII alone change.
std::string in_small_letters(std::string_view text);

}  // namespace rubsweep::table
