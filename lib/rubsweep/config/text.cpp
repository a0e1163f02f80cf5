#include "rubsweep/config/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace rubsweep::config {
namespace {

struct Lead {
  std::size_t length;  // of the sequence, 0 for a byte that cannot start one
  std::uint32_t bits;  // of the code point
  std::uint32_t low;   // smallest code point that needs this length
};

Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if ((byte & 0xe0) == 0xc0) return {2, byte & 0x1fU, 0x80};
  if ((byte & 0xf0) == 0xe0) return {3, byte & 0x0fU, 0x800};
  if ((byte & 0xf8) == 0xf0) return {4, byte & 0x07U, 0x10000};
  return {0, 0, 0};
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const Lead lead = lead_of(static_cast<unsigned char>(text[0]));
  if (lead.length > text.size()) return 0;
  std::uint32_t code = lead.bits;
  for (std::size_t i = 1; i < lead.length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if ((byte & 0xc0) != 0x80) return 0;
    code = (code << 6) | (byte & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < lead.low || code > 0x10ffff || surrogate ? 0 : lead.length;
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
