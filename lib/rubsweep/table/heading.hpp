#pragma once

#include <string>
#include <string_view>

namespace rubsweep::table {

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

}  // namespace rubsweep::table
