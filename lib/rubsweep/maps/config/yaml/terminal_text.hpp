#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::yaml {

/// Remembers lines of a message as it was shown; those behind the first 1000 are forgotten. For any thread.
void remember_lines(std::string_view shown);

/// Lines of all messages that this process showed on stderr, without empty ones.
std::vector<std::string> said_lines();

enum class ControlCharacters { none, tabs_and_line_ends };

/// Appends the first character or stray byte of `text`, in a form safe for a terminal, and returns its bytes.
/// Control characters but the `kept` ones become `\xNN`, U+0080 to U+009F among them, which terminals obey as
/// they do an escape sequence, and so do bytes that are no UTF-8. `text` is not empty.
std::size_t append_shown(std::string& result, std::string_view text, ControlCharacters kept);

/// `text` of any number of lines fit for a terminal.
std::string printable(std::string_view text);

/// Prints on stderr, control characters as `\xNN`: text from files and names moves no cursor. A message that
/// cannot be delivered changes nothing else.
void say(const std::string& text);

}  // namespace rubsweep::config::yaml
