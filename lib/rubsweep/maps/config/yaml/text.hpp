#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::yaml {

/// Bytes of the valid UTF-8 sequence that `text` starts with (1 to 4); 0 when there is none.
std::size_t utf8_length(std::string_view text);

/// True for the bytes 0x00 to 0x1f and 0x7f.
bool is_control(char byte);

/// Whether a UTF-8 character is one that a terminal or a page does not show as it is: a control character of
/// ASCII or Latin-1, a separator of lines or paragraphs, or one that turns the direction of writing.
bool is_hidden(std::string_view character);

/// Offset of the first character that looks like a blank, or is invisible, and is neither to YAML: a no-break
/// space, those of a typesetter, a byte order mark inside. Empty when there is none.
std::optional<std::size_t> find_foreign_blank(std::string_view text);

/// The character that a text begins with, in words: "a no-break space (U+00A0)".
std::string describe_character(std::string_view text);

/// Every byte as `\xNN`.
std::string escaped(std::string_view bytes);

/// Offset of the first byte that a configuration may not hold: not UTF-8, or a control character other than
/// tab and line ends. Empty when there is none.
std::optional<std::size_t> first_unreadable_byte(std::string_view text);

/// `text` fit for one line of a message: control characters and stray bytes as `\xNN`, cut after about
/// `longest` bytes.
std::string shown(std::string_view text, std::size_t longest = 60);

/// Dotted path of the child `name` of `path`, fit for a message.
std::string child_path(std::string_view path, std::string_view name);

/// Remembers lines of a message as it was shown; those behind the first 1000 are forgotten. For any thread.
void remember_lines(std::string_view shown);

/// Lines of all messages that this process showed on stderr, without empty ones.
std::vector<std::string> said_lines();

/// `text` of any number of lines fit for a terminal.
std::string printable(std::string_view text);

/// Prints on stderr, control characters as `\xNN`: text from files and names moves no cursor. A message that
/// cannot be delivered changes nothing else.
void say(const std::string& text);

/// The one of `names` that `word` most probably means: the shortest one that only adds a unit to it ("mass"
/// -> "mass_kg"), else the one with the smallest edit distance (insert, delete, replace: 1 each), the first
/// listed of equals. Empty when none is within a third of its own length.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> names);

enum class NumberError {
  none,
  not_a_number,
  not_finite,   ///< a word of YAML's or C's for infinity or NaN
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
