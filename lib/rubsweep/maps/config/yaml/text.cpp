#include "rubsweep/maps/config/yaml/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>

#include "rubsweep/maps/config/yaml/terminal_text.hpp"

namespace rubsweep::config::yaml {
namespace {

boost::locale::utf::code_point first_code(std::string_view text) {
  const char* begin = text.data();
  return boost::locale::utf::utf_traits<char>::decode(begin, text.data() + text.size());
}

bool is_foreign_blank(boost::locale::utf::code_point code) {
  return code == 0xa0 || code == 0x1680 || (code >= 0x2000 && code <= 0x200d) || code == 0x202f ||
         code == 0x205f || code == 0x2060 || code == 0x3000 || code == 0xfeff;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  namespace utf = boost::locale::utf;
  const char* end = text.data();
  const auto code = utf::utf_traits<char>::decode(end, text.data() + text.size());
  if (code == utf::illegal || code == utf::incomplete) return 0;
  return static_cast<std::size_t>(end - text.data());
}

bool is_control(char byte) {
  const auto value = static_cast<unsigned char>(byte);
  return value < 0x20 || value == 0x7f;
}

bool is_hidden(std::string_view character) {
  namespace utf = boost::locale::utf;
  const utf::code_point code = first_code(character);
  const auto within = [code](utf::code_point low, utf::code_point high) {
    return code >= low && code <= high;
  };
  return code == utf::illegal || code == utf::incomplete || within(0, 0x1f) || within(0x7f, 0x9f) ||
         within(0x200e, 0x200f) || within(0x2028, 0x202e) || within(0x2066, 0x2069) || code == 0xfeff;
}

std::optional<std::size_t> find_foreign_blank(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    if (length > 1 && is_foreign_blank(first_code(text.substr(i)))) return i;
    i += std::max<std::size_t>(length, 1);
  }
  return std::nullopt;
}

std::string describe_character(std::string_view text) {
  const auto code = static_cast<unsigned>(first_code(text));
  const bool no_break = code == 0xa0 || code == 0x202f;
  return fmt::format("{} (U+{:04X})", no_break ? "a no-break space" : "a character that looks like a blank",
                     code);
}

std::string escaped(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  return text;
}

std::optional<std::size_t> first_unreadable_byte(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text.substr(i));
    const bool white = text[i] == '\t' || text[i] == '\n' || text[i] == '\r';
    if (length == 0 || (is_control(text[i]) && !white)) return i;
    i += length;
  }
  return std::nullopt;
}

std::string shown(std::string_view text, std::size_t longest) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (result.size() >= longest) return result + "...";
    i += append_shown(result, text.substr(i), ControlCharacters::none);
  }
  return result;
}

std::string child_path(std::string_view path, std::string_view name) {
  const std::string last = name.empty() ? "''" : shown(name);
  return path.empty() ? last : fmt::format("{}.{}", path, last);
}

}  // namespace rubsweep::config::yaml
