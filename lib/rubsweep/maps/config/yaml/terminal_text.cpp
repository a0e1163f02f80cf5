#include "rubsweep/maps/config/yaml/terminal_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <mutex>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

constexpr std::size_t most_lines = 1000;

std::mutex mutex;  // guards the lines

std::vector<std::string>& lines() {
  static std::vector<std::string> of_this_process;
  return of_this_process;
}

/// U+0080 to U+009F, of a whole character.
bool is_second_control(std::string_view character) {
  return character.size() == 2 && character[0] == '\xc2' && static_cast<unsigned char>(character[1]) < 0xa0;
}

}  // namespace

void remember_lines(std::string_view shown) {
  const std::lock_guard lock(mutex);
  while (!shown.empty() && lines().size() < most_lines) {
    const std::size_t end = std::min(shown.find('\n'), shown.size());
    if (end > 0) lines().emplace_back(shown.substr(0, end));
    shown.remove_prefix(std::min(end + 1, shown.size()));
  }
}

std::vector<std::string> said_lines() {
  const std::lock_guard lock(mutex);
  return lines();
}

std::size_t append_shown(std::string& result, std::string_view text, ControlCharacters kept) {
  const std::size_t length = utf8_length(text);
  const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
  const bool white = character == "\n" || character == "\t";
  const bool control = is_control(character[0]) || is_second_control(character);
  if (length > 0 && (!control || (white && kept == ControlCharacters::tabs_and_line_ends))) {
    result += character;
  } else {
    for (const char byte : character) result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  }
  return character.size();
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();)
    i += append_shown(result, text.substr(i), ControlCharacters::tabs_and_line_ends);
  return result;
}

void say(const std::string& text) {
  const std::string shown = printable(text);
  std::fputs(shown.c_str(), stderr);
  remember_lines(shown);
}

}  // namespace rubsweep::config::yaml
