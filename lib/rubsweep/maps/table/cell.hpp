#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::table {

/// How the numbers of a table are written.
struct NumberStyle {
  char separator = ',';
  bool decimal_comma = false;
};

/// Fault of a text, and its place.
struct Fault {
  std::size_t line = 1, column = 1;
  std::string wrong, allowed;
};

/// Most cells of a line: more are no table of signals.
inline constexpr std::size_t most_cells = std::size_t{1} << 16;

/// The cells of a line, at most one more than most_cells, without blanks and quotes about them; of the
/// separator ' ' any blanks part them.
std::vector<std::string_view> cells_of(std::string_view line, char separator);

/// The number in a cell, NaN for an empty one or one that says NaN; nothing where it is no number, infinity
/// included. Exponents are written with e, or with d and a sign as in Fortran.
std::optional<double> number_in(std::string_view cell, const NumberStyle& style);

/// Words of a table above a column.
struct Heading {
  std::string name{}, unit{};  ///< the unit without brackets
};

/// Parts "name (unit)" or "name [unit]".
Heading heading_of(std::string_view cell);

/// A unit without the signs and blanks that stand between its parts: "N-s/m", "N s/m" and "N·s/m" are "Ns/m";
/// both signs for micro are u.
std::string plain_unit(std::string_view unit);

/// Whether a cell says a unit and nothing else: a known one, or anything in brackets.
bool is_unit(std::string_view cell);

/// A text of a file fit for names and messages: control characters become question marks.
std::string printable(std::string_view text);

/// Letters of ASCII alone change.
std::string in_small_letters(std::string_view text);

}  // namespace rubsweep::table
