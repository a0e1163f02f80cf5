#pragma once

#include <string_view>

namespace rubsweep::config::yaml {

enum class NumberError {
  none,
  not_a_number,
  not_finite,   ///< one of YAML's or C's words for infinity and NaN
  does_not_fit  ///< a decimal number too large or too small for a double
};

struct ParsedNumber {
  double value = 0;  ///< nearest double; 0 when there is an error
  NumberError error = NumberError::none;
};

/// Reads a whole word as a decimal number: optional sign, digits with an optional point, optional exponent.
/// Knows no hexadecimal, octal, digit separators, decimal comma or surrounding blanks; leading zeros mean
/// nothing.
ParsedNumber parse_number(std::string_view word);

}  // namespace rubsweep::config::yaml
