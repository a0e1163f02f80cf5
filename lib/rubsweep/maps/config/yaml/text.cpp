#include "rubsweep/maps/config/yaml/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <mutex>
#include <numeric>
#include <system_error>

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

constexpr std::size_t most_lines = 1000;

std::mutex mutex;  // guards `lines`

std::vector<std::string>& lines() {
  static std::vector<std::string> of_this_process;
  return of_this_process;
}

/// Whether a whole UTF-8 character is one of the control characters U+0080 to U+009F.
bool is_second_control(std::string_view character) {
  return character.size() == 2 && character[0] == '\xc2' && static_cast<unsigned char>(character[1]) < 0xa0;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

bool adds_a_unit(std::string_view name, std::string_view word) {
  return !word.empty() && name.size() > word.size() && name.starts_with(word) && name[word.size()] == '_';
}

std::string_view without_sign(std::string_view word) {
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  return word;
}

bool names_non_finite(std::string_view word) {
  word = without_sign(word);
  if (word.starts_with('.')) word.remove_prefix(1);
  std::string lower(word);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<std::string_view, 3> names{"inf", "infinity", "nan"};
  return std::find(names.begin(), names.end(), lower) != names.end();
}

enum class ControlCharacters { none, tabs_and_line_ends };

/// Appends the first character or stray byte of `text` in a form that is safe for a terminal, and returns its
/// length in bytes. `\xNN` replaces bytes that are not UTF-8, and control characters except the `kept` ones.
/// This includes U+0080 to U+009F, which terminals obey like escape sequences. `text` must not be empty.
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

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> names) {
  std::optional<std::string_view> best;
  for (const std::string_view name : names) {
    if (adds_a_unit(name, word) && (!best || name.size() < best->size())) best = name;
  }
  if (best) return best;
  std::size_t smallest = 0;
  for (const std::string_view name : names) {
    const std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    if (word.size() > name.size() + limit) continue;
    const std::size_t distance = edit_distance(word, name);
    if (distance > limit || (best && distance >= smallest)) continue;
    best = name;
    smallest = distance;
  }
  return best;
}

ParsedNumber parse_number(std::string_view word) {
  const std::string_view digits = without_sign(word);
  // from_chars alone would accept "inf", "nan" and a second sign.
  const bool starts_well = !digits.empty() && (digits[0] == '.' || (digits[0] >= '0' && digits[0] <= '9'));
  if (names_non_finite(word)) return {0, NumberError::not_finite};
  if (!starts_well) return {0, NumberError::not_a_number};
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {0, NumberError::not_a_number};
  if (error != std::errc{}) return {0, NumberError::does_not_fit};
  return {word.starts_with('-') ? -value : value, NumberError::none};
}

}  // namespace rubsweep::config::yaml
