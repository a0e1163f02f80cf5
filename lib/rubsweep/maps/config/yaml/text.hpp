#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::yaml {

/// Length in bytes, 1 to 4, of the valid UTF-8 sequence at the begin of `text`; 0 where there is none.
std::size_t utf8_length(std::string_view text);

bool is_control(char byte);  ///< True for the bytes 0x00 to 0x1f and 0x7f.

/// Whether a terminal or a page does not show a UTF-8 character as it is. Such characters are control
/// characters of ASCII or Latin-1, separators of lines or paragraphs, and those that turn the direction of
/// writing.
bool is_hidden(std::string_view character);

/// Offset of the first character that looks like a blank or is invisible, but is no blank to YAML: a no-break
/// space, a typographic space, a byte order mark inside the text. Empty where there is none.
std::optional<std::size_t> find_foreign_blank(std::string_view text);

/// Name of the first character of a text: "a no-break space (U+00A0)".
std::string describe_character(std::string_view text);

std::string escaped(std::string_view bytes);  ///< Writes every byte as `\xNN`.

/// Offset of the first byte that a configuration may not hold: not UTF-8, or a control character other than
/// tab and line ends. Empty when there is none.
std::optional<std::size_t> first_unreadable_byte(std::string_view text);

/// `text` in a form that fits one line of a message: control characters and stray bytes become `\xNN`, and
/// the text is cut after about `longest` bytes.
std::string shown(std::string_view text, std::size_t longest = 60);

/// Dotted path of the child `name` of `path`, fit for a message.
std::string child_path(std::string_view path, std::string_view name);

/// Remembers the first 1000 lines of the messages that were shown. Any thread may call it.
void remember_lines(std::string_view shown);

/// Lines of all messages that this process showed on stderr, without empty ones.
std::vector<std::string> said_lines();

std::string printable(std::string_view text);  ///< `text` of any number of lines, made safe for a terminal.

/// Prints on stderr, with control characters as `\xNN`, so that text from files cannot move the cursor. A
/// message that cannot be written is dropped silently.
void say(const std::string& text);

/// Name out of `names` that `word` most probably means. This is the shortest name that only adds a unit to
/// `word` ("mass" -> "mass_kg"), or else the name with the smallest edit distance (insert, delete, replace: 1
/// each). Of several equally near names the first one wins. Empty where no name is within a third of its own
/// length.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> names);

enum class NumberError {
  none,
  not_a_number,
  not_finite,   ///< a word for infinity or NaN as in YAML or C
  does_not_fit  ///< a decimal number too large or too small for a double
};

struct ParsedNumber {
  double value = 0;  ///< nearest double; 0 when there is an error
  NumberError error = NumberError::none;
};

/// Reads a whole word as a decimal number: optional sign, digits with an optional point, optional exponent.
/// Hexadecimal, digit separators, a decimal comma and blanks are refused. Leading zeros do not mean octal.
ParsedNumber parse_number(std::string_view word);

}  // namespace rubsweep::config::yaml
