#include "rubsweep/config/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/locale/utf.hpp>

namespace rubsweep::config {
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
    const std::size_t length = utf8_length(text.substr(i));
    if (length == 0 || is_control(text[i])) {
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i]));
    } else {
      result += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string child_path(std::string_view path, std::string_view name) {
  const std::string last = name.empty() ? "''" : shown(name);
  return path.empty() ? last : fmt::format("{}.{}", path, last);
}

}  // namespace rubsweep::config
