#include "rubsweep/maps/table/encoding.hpp"

#include <cstdint>

#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::table {
namespace {

void append(std::string& text, std::uint32_t letter) {
  if (letter < 0x80) {
    text += static_cast<char>(letter);
  } else if (letter < 0x800) {
    text += static_cast<char>(0xc0 | letter >> 6);
    text += static_cast<char>(0x80 | (letter & 0x3f));
  } else {
    text += static_cast<char>(0xe0 | letter >> 12);
    text += static_cast<char>(0x80 | (letter >> 6 & 0x3f));
    text += static_cast<char>(0x80 | (letter & 0x3f));
  }
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto first = static_cast<unsigned char>(bytes[i]);
    if (first < 0x80) continue;
    std::size_t more = 0;
    if (first >= 0xc2 && first <= 0xdf) more = 1;
    if (first >= 0xe0 && first <= 0xef) more = 2;
    if (first >= 0xf0 && first <= 0xf4) more = 3;
    if (more == 0 || more >= bytes.size() - i) return false;
    for (; more > 0; --more)
      if ((static_cast<unsigned char>(bytes[++i]) & 0xc0) != 0x80) return false;
  }
  return true;
}

std::string of_utf16(std::string_view bytes, bool large_end_first) {
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    const std::uint32_t letter = large_end_first ? 256u * first + second : 256u * second + first;
    // A half of a pair stands for a sign that no number, name or unit has.
    append(text, letter >= 0xd800 && letter <= 0xdfff ? '?' : letter);
  }
  return text;
}

}  // namespace

std::string utf8_of(std::string_view bytes) {
  std::string text;
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    text = of_utf16(bytes.substr(2), bytes.front() == '\xFE');
  } else if (bytes.starts_with("\xEF\xBB\xBF")) {
    text = bytes.substr(3);
  } else if (is_utf8(bytes)) {
    text = bytes;
  } else {
    for (const char byte : bytes) append(text, static_cast<unsigned char>(byte));
  }
  if (text.find('\0') != std::string::npos) throw Fault{1, 1, "is no text", "a table of numbers"};
  return text;
}

}  // namespace rubsweep::table
