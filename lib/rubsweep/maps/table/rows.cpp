#include "rubsweep/maps/table/rows.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "rubsweep/maps/table/cell.hpp"
#include "rubsweep/maps/table/judged_columns.hpp"
#include "rubsweep/maps/table/time_stamp.hpp"

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
    // A character outside the basic plane, written as two halves, occurs in no number, name or unit.
    append(text, letter >= 0xd800 && letter <= 0xdfff ? '?' : letter);
  }
  return text;
}

/// Detects UTF-16 without a byte order mark: every second byte of its first letters is zero. True: the first
/// byte of each pair is.
std::optional<bool> zero_in_a_pair(std::string_view bytes) {
  constexpr std::size_t looked_at = 64;
  if (bytes.size() < 8 || bytes.size() % 2 != 0) return std::nullopt;
  std::array<std::size_t, 2> zeros{};
  const std::size_t count = std::min(looked_at, bytes.size());
  for (std::size_t i = 0; i < count; ++i) zeros[i % 2] += bytes[i] == '\0';
  for (const bool first : {false, true})
    if (zeros[first ? 1 : 0] == 0 && 4 * zeros[first ? 0 : 1] > count) return first;
  return std::nullopt;
}

/// Words that instruments write instead of a reading: out of range, or missing.
bool stands_for_a_reading(std::string_view cell) {
  constexpr std::array<std::string_view, 14> words{"nan",      "-nan", "\u221e", "-\u221e", "+\u221e",
                                                   "ol",       "ovl",  "ovld",   "over",    "overload",
                                                   "overflow", "---",  "n/a",    "#n/a"};
  return std::ranges::find(words, in_small_letters(cell)) != words.end();
}

bool begins_a_number(std::string_view cell) {
  const std::size_t digit = cell.find_first_not_of("+-.");
  return digit < std::min<std::size_t>(cell.size(), 3) && cell[digit] >= '0' && cell[digit] <= '9';
}

bool says_words_alone(const std::vector<std::string_view>& cells, char separator) {
  const auto reads = [&](std::string_view cell) {
    return begins_a_number(cell) || is_number(cell, separator) || stands_for_a_reading(cell);
  };
  return std::ranges::any_of(cells, [](auto cell) { return !cell.empty(); }) &&
         std::ranges::none_of(cells, reads);
}

/// A cell in a form that is suitable for a message.
std::string quoted(std::string_view cell) { return '\'' + printable(cell.substr(0, 40)) + '\''; }

}  // namespace

std::string utf8_of(std::string_view bytes) {
  std::string text;
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    text = of_utf16(bytes.substr(2), bytes.front() == '\xFE');
  } else if (bytes.starts_with("\xEF\xBB\xBF")) {
    text = bytes.substr(3);
  } else if (const auto first = zero_in_a_pair(bytes)) {
    text = of_utf16(bytes, *first);
  } else if (is_utf8(bytes)) {
    text = bytes;
  } else {
    for (const char byte : bytes) append(text, static_cast<unsigned char>(byte));
  }
  if (text.find('\0') != std::string::npos) throw Fault{1, 1, "is no text", "a table of numbers"};
  return text;
}

Rows::Rows(std::string_view text, const Layout& layout)
    : layout_(layout),
      rest_(text.substr(layout.numbers_offset)),
      style_{layout.separator, false},
      next_line_(layout.numbers_line) {}

bool Rows::read_line() {
  do {
    if (rest_.empty()) return false;
    text_ = take_line(rest_);
    line_ = next_line_++;
  } while (is_comment(text_));
  if (first_line_ == 0) first_line_ = line_;
  cells_ = cells_of(text_, layout_.separator);
  return true;
}

bool Rows::take_cells() {
  const auto filled =
      std::ranges::find_if(cells_.rbegin(), cells_.rend(), [](auto cell) { return !cell.empty(); });
  if (cells_.size() < layout_.fewest_cells || cells_.rend() - filled > std::ssize(layout_.columns))
    throw Fault{line_, 1, "has another number of cells, " + std::to_string(cells_.size()),
                std::to_string(layout_.columns.size()) +
                    (first_line_ == line_ ? ", as many as there are names"
                                          : " as in line " + std::to_string(first_line_))};
  cells_.resize(std::min(cells_.size(), layout_.columns.size()));
  return true;
}

bool Rows::next() { return read_line() && take_cells(); }

bool Rows::next_reading() {
  while (read_line()) {
    if (begins_a_number(cells_[0]) || !says_words_alone(cells_, layout_.separator)) return take_cells();
    notes_.push_back(line_);
  }
  return false;
}

bool Rows::is_empty() const {
  return std::ranges::all_of(cells_, [](std::string_view cell) { return cell.empty(); });
}

bool Rows::is_number(std::size_t column) const {
  const std::string_view cell = cells_[column];
  return !cell.empty() && (may_part_thousands(cell) || number_in(cell, style_) ||
                           number_in(cell, {style_.separator, true}) || number_in(cell, {}));
}

std::size_t Rows::place_of(std::size_t column) const {
  return static_cast<std::size_t>(cells_[column].data() - text_.data()) + 1;
}

Fault Rows::fault(std::size_t column, const std::string& wrong, const std::string& allowed) const {
  return {line_, place_of(column), quoted(cells_[column]) + ' ' + wrong, allowed};
}

void Rows::look_at(std::string_view cell, std::size_t column) {
  if (style_.separator == ',' && may_part_thousands(cell))
    throw fault(column, "may have a decimal comma, or commas between thousands",
                "numbers without signs between thousands");
  const bool comma = cell.find(',') != std::string_view::npos && !style_.decimal_comma;
  if (comma && point_line_ > 0)
    throw fault(column, "has a decimal comma, and numbers before it have points",
                "points as in line " + std::to_string(point_line_) + ", or commas, in all numbers");
  style_.decimal_comma = style_.decimal_comma || comma;
  if (cell.find('.') != std::string_view::npos && point_line_ == 0) point_line_ = line_;
}

double Rows::number(std::size_t column) {
  look_at(cells_[column], column);
  const auto value = number_in(cells_[column], style_);
  if (!value)
    throw fault(column, "is no number",
                style_.decimal_comma ? "a number with a decimal comma" : "a number with a decimal point");
  return *value;
}

double Rows::reading(std::size_t column) {
  if (stands_for_a_reading(cells_[column])) return std::numeric_limits<double>::quiet_NaN();
  return number(column);
}

double Rows::time_stamp(std::size_t column) {
  for (const bool comma : {false, true})
    if (const auto stamp = time_stamp_in(cells_[column], {style_.separator, comma})) return *stamp;
  throw fault(column, "is no time stamp", "hours:minutes:seconds, with or without a date before them");
}

}  // namespace rubsweep::table
