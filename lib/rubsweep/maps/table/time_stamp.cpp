#include "rubsweep/maps/table/time_stamp.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <string>
#include <vector>

namespace rubsweep::table {
namespace {

constexpr double hour_s = 3600, minute_s = 60, day_s = 86400;

std::optional<double> whole_number(std::string_view digits) {
  int value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size() || value < 0)
    return std::nullopt;
  return value;
}

/// Number of a month, given as a number or by the first three letters of its English name.
std::optional<double> month_in(std::string_view word) {
  constexpr std::array<std::string_view, 12> names{"jan", "feb", "mar", "apr", "may", "jun",
                                                   "jul", "aug", "sep", "oct", "nov", "dec"};
  const auto name = std::ranges::find(names, in_small_letters(word.substr(0, 3)));
  if (name != names.end()) return static_cast<double>(name - names.begin() + 1);
  return whole_number(word);
}

std::vector<std::string_view> parts_of(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  constexpr std::size_t most = 4;
  while (parts.size() < most) {
    const std::size_t end = text.find(mark);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return parts;
}

/// Seconds from 1970 to the begin of a day.
std::optional<double> day_in(std::string_view date) {
  using namespace std::chrono;
  constexpr std::string_view marks = "-./";
  const std::size_t mark = date.find_first_of(marks);
  if (mark == std::string_view::npos) return std::nullopt;
  auto parts = parts_of(date, date[mark]);
  if (parts.size() != 3) return std::nullopt;
  if (mark == 4) std::swap(parts[0], parts[2]);
  // The day comes before the month, except in dates with slashes, in which Americans write the month first.
  if (date[mark] == '/' && mark != 4 && whole_number(parts[0]).value_or(13) <= 12)
    std::swap(parts[0], parts[1]);
  const auto y = whole_number(parts[2]), m = month_in(parts[1]), d = whole_number(parts[0]);
  if (!y || !m || !d || *m > 12 || *d > 31) return std::nullopt;
  const year_month_day day{year(static_cast<int>(*y)), month(static_cast<unsigned>(*m)),
                           std::chrono::day(static_cast<unsigned>(*d))};
  if (!day.ok()) return std::nullopt;
  return day_s * static_cast<double>(sys_days(day).time_since_epoch().count());
}

void take_blanks_off(std::string_view& text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
}

/// Removes a time zone from the end of a time, and returns by how many seconds it is ahead of universal time.
double take_zone(std::string_view& time) {
  for (const std::string_view word : {"Z", "UTC", "GMT"})
    if (time.ends_with(word)) {
      time.remove_suffix(word.size());
      take_blanks_off(time);
      return 0;
    }
  const std::size_t sign = time.find_last_of("+-");
  if (sign == std::string_view::npos || sign == 0) return 0;
  std::string digits(time.substr(sign + 1));
  std::erase(digits, ':');
  if (digits.size() == 2) digits += "00";
  const auto number = digits.size() == 4 ? whole_number(digits) : std::nullopt;
  if (!number) return 0;
  const auto minutes = static_cast<int>(*number);  // two digits of hours, two of minutes
  if (minutes / 100 > 14 || minutes % 100 >= 60) return 0;
  const double ahead_s = hour_s * (minutes / 100) + minute_s * (minutes % 100);
  const bool behind = time[sign] == '-';
  time = time.substr(0, sign);
  take_blanks_off(time);
  return behind ? -ahead_s : ahead_s;
}

/// Removes AM or PM from the end of a time, and returns the hours to which it moves 12 o'clock; empty without
/// AM or PM.
std::optional<double> take_half_of_day(std::string_view& time) {
  const std::string small =
      in_small_letters(time.substr(time.size() - std::min<std::size_t>(4, time.size())));
  for (const std::string_view word : {"am", "pm", "a.m.", "p.m."})
    if (small.ends_with(word)) {
      time.remove_suffix(word.size());
      take_blanks_off(time);
      return word.front() == 'p' ? 12 : 0;
    }
  return std::nullopt;
}

/// End of the date in a cell: a blank or T before the hour follows; 0: there is no date.
std::size_t end_of_date(std::string_view cell) {
  const std::size_t colon = cell.find(':');
  if (colon == std::string_view::npos) return 0;
  const std::size_t gap = cell.substr(0, colon).find_last_of(" T");
  return gap == std::string_view::npos ? 0 : gap;
}

}  // namespace

std::optional<double> time_stamp_in(std::string_view cell, const NumberStyle& style) {
  double begin_s = 0;
  if (const std::size_t gap = end_of_date(cell); gap > 0) {
    std::string_view date = cell.substr(0, gap);
    take_blanks_off(date);
    const auto day = day_in(date);
    if (!day) return std::nullopt;
    begin_s = *day;
    cell.remove_prefix(gap + 1);
  }
  begin_s -= take_zone(cell);
  const auto half = take_half_of_day(cell);
  const auto parts = parts_of(cell, ':');
  if (parts.size() != 3 || parts[2].empty()) return std::nullopt;
  auto hours = whole_number(parts[0]);
  const auto minutes = whole_number(parts[1]), seconds = number_in(parts[2], style);
  if (!hours || !minutes || !seconds || *hours >= 24 || *minutes >= 60 || !(*seconds >= 0 && *seconds < 61))
    return std::nullopt;
  if (half && (*hours < 1 || *hours > 12)) return std::nullopt;
  if (half) hours = (*hours == 12 ? 0 : *hours) + *half;
  return begin_s + hour_s * *hours + minute_s * *minutes + *seconds;
}

}  // namespace rubsweep::table
