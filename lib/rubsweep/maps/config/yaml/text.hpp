#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace rubsweep::config::yaml
