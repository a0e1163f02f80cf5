#include "rubsweep/measurement/recording/universal_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/matlab/bytes.hpp"
#include "rubsweep/maps/table/cell.hpp"
#include "rubsweep/maps/table/layout.hpp"

namespace rubsweep::recording {
namespace {

using table::Fault;

constexpr std::size_t head_lines = 11;
constexpr std::string_view allowed_set = "a whole data set 58 or 58b";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

bool is_mark(std::string_view line) { return trimmed(line) == "-1"; }

/// Lines of the file, counted.
struct Cursor {
  std::string_view rest;
  std::size_t line = 0;

  std::string_view take() {
    if (rest.empty())
      throw Fault{line, 1, "is the last line, in the middle of a data set", std::string(allowed_set)};
    ++line;
    return table::take_line(rest);
  }
};

/// A field of fixed width.
std::string_view field(std::string_view line, std::size_t begin, std::size_t width) {
  return begin < line.size() ? trimmed(line.substr(begin, width)) : std::string_view();
}

double number_of(std::string_view line, std::size_t begin, std::size_t width, std::size_t at) {
  const std::string_view text = field(line, begin, width);
  const auto value = table::number_in(text, {' '});
  if (text.empty() || !value || !std::isfinite(*value))
    throw Fault{at, begin + 1, "has no number there", std::string(allowed_set)};
  return *value;
}

/// The code as a whole number of a few digits; 0 for any other value.
int code_of(double value) {
  constexpr double largest = 10000;
  return std::abs(value) <= largest ? static_cast<int>(value) : 0;
}

std::string word_of(std::string_view line, std::size_t begin, std::size_t width) {
  const std::string_view word = field(line, begin, width);
  return word == "NONE" ? std::string() : std::string(word);
}

/// Header and numbers of a data set.
struct Set {
  std::string title{}, point{}, unit{}, time_unit{};
  int function = 0, ordinate = 0, abscissa_kind = 0;
  std::size_t points = 0, line = 0;
  bool even = false;
  double begin = 0, step = 0;
  std::vector<double> times{}, values{};

  bool complex() const { return ordinate == 5 || ordinate == 6; }
  bool double_precision() const { return ordinate == 4 || ordinate == 6; }
  std::size_t numbers() const { return points * (complex() ? (even ? 2u : 3u) : (even ? 1u : 2u)); }
};

std::string point_of(std::string_view line) {
  constexpr std::array<std::string_view, 4> axes{"", "X", "Y", "Z"};
  const std::string name = word_of(line, 31, 10), node(field(line, 41, 10));
  const auto direction = code_of(table::number_in(field(line, 51, 4), {' '}).value_or(0));
  std::string text = name.empty() ? node : name + ' ' + node;
  if (direction != 0 && std::abs(direction) < 4)
    text +=
        fmt::format(":{}{}", direction < 0 ? '-' : '+', axes[static_cast<std::size_t>(std::abs(direction))]);
  return text;
}

Set read_head(Cursor& in) {
  Set set;
  set.line = in.line;
  std::array<std::string_view, head_lines> lines;
  for (std::string_view& line : lines) line = in.take();
  set.title = word_of(lines[0], 0, 80);
  set.point = point_of(lines[5]);
  const std::size_t first = in.line - head_lines + 1;
  set.function = code_of(number_of(lines[5], 0, 5, first + 5));
  set.ordinate = code_of(number_of(lines[6], 0, 10, first + 6));
  const double points = number_of(lines[6], 10, 10, first + 6),
               spacing = number_of(lines[6], 20, 10, first + 6);
  set.even = spacing == 1;
  set.begin = number_of(lines[6], 30, 13, first + 6);
  set.step = number_of(lines[6], 43, 13, first + 6);
  const bool known = set.ordinate == 2 || set.ordinate == 4 || set.complex();
  if (!known || !(points >= 0) || points > static_cast<double>(in.rest.size()) ||
      (spacing != 0 && spacing != 1) || (set.even && !(set.step > 0)))
    throw Fault{first + 6, 1, "has no kind, count or step of numbers that there is room for",
                std::string(allowed_set)};
  set.points = static_cast<std::size_t>(points);
  set.abscissa_kind = code_of(number_of(lines[7], 0, 10, first + 7));
  set.time_unit = word_of(lines[7], 47, 20);
  set.unit = word_of(lines[8], 47, 20);
  return set;
}

/// Numbers of a text, separated by blanks or by their signs.
std::vector<double> read_text_numbers(Cursor& in, std::size_t count) {
  std::vector<double> numbers;
  numbers.reserve(std::min(count, in.rest.size()));
  while (numbers.size() < count) {
    const std::string_view line = in.take();
    for (std::size_t begin = line.find_first_not_of(" \t"); begin != std::string_view::npos;
         begin = line.find_first_not_of(" \t", begin)) {
      std::size_t end = begin + 1;
      const auto goes_on = [&] {
        const char before = line[end - 1], now = line[end];
        if (now == ' ' || now == '\t') return false;
        return (now != '-' && now != '+') || before == 'e' || before == 'E' || before == 'd' || before == 'D';
      };
      while (end < line.size() && goes_on()) ++end;
      const auto value = table::number_in(line.substr(begin, end - begin), {' '});
      if (!value || numbers.size() == count || is_mark(line))
        throw Fault{in.line, begin + 1, "is no number of this data set", std::string(allowed_set)};
      numbers.push_back(*value);
      begin = end;
    }
  }
  return numbers;
}

/// Numbers of a set 58b; its first line gives the byte order and the number of bytes.
std::vector<double> read_binary_numbers(Cursor& in, std::string_view first, const Set& set) {
  const double order = number_of(first, 7, 6, set.line), form = number_of(first, 13, 6, set.line),
               lines = number_of(first, 19, 12, set.line), bytes = number_of(first, 31, 12, set.line);
  if ((order != 1 && order != 2) || form != 2 || lines != head_lines)
    throw Fault{set.line, 1, "announces binary numbers of another kind", "those of IEEE 754 behind 11 lines"};
  const std::size_t size = set.double_precision() ? 8 : 4, per_point = set.complex() ? 2 : 1;
  // With uneven steps, times have four bytes according to the format, but some programs write eight.
  const double room = static_cast<double>(in.rest.size());
  const auto needs = [&](std::size_t of_time) {
    return static_cast<double>(set.points) * static_cast<double>(size * per_point + (set.even ? 0 : of_time));
  };
  const std::size_t of_time = bytes == needs(4) && !set.even ? 4 : size;
  if (bytes != needs(of_time) || bytes > room)
    throw Fault{set.line, 1, "announces other bytes than its numbers have, or than there are",
                std::string(allowed_set)};
  constexpr bool here_little = std::endian::native == std::endian::little;
  matlab::Bytes all(in.rest.substr(0, static_cast<std::size_t>(bytes)), (order == 1) != here_little);
  in.rest.remove_prefix(static_cast<std::size_t>(bytes));
  std::vector<double> numbers;
  const auto take = [&](std::size_t width) {
    numbers.push_back(width == 4 ? static_cast<double>(all.number<float>()) : all.number<double>());
  };
  for (std::size_t k = 0; k < set.points; ++k) {
    if (!set.even) take(of_time);
    for (std::size_t i = 0; i < per_point; ++i) take(size);
  }
  return numbers;
}

Set read_set(Cursor& in, std::string_view first, bool binary) {
  Set set = read_head(in);
  const std::vector<double> numbers =
      binary ? read_binary_numbers(in, first, set) : read_text_numbers(in, set.numbers());
  if (set.complex()) return set;
  for (std::size_t k = 0; k < set.points; ++k) {
    set.times.push_back(set.even ? set.begin + set.step * static_cast<double>(k) : numbers[2 * k]);
    set.values.push_back(numbers[set.even ? k : 2 * k + 1]);
  }
  return set;
}

/// The next line that is not blank.
std::string_view take_filled(Cursor& in) {
  std::string_view line = in.take();
  while (trimmed(line).empty()) line = in.take();
  return line;
}

/// Reads all data sets of type 58; other types are left out.
std::vector<Set> read_sets(std::string_view bytes, Channels& table) {
  Cursor in{bytes};
  std::vector<Set> sets;
  while (in.rest.find_first_not_of(" \t\r\n") != std::string_view::npos) {
    if (!is_mark(take_filled(in))) throw Fault{in.line, 1, "stands between two data sets", "-1"};
    const std::string_view first = in.take(), kind = trimmed(first.substr(0, 7));
    if (kind == "58" || kind == "58b") {
      sets.push_back(read_set(in, first, kind == "58b"));
      if (!is_mark(take_filled(in))) throw Fault{in.line, 1, "stands behind the numbers of a data set", "-1"};
      continue;
    }
    const std::string name = "data set " + std::string(kind);
    if (std::ranges::find(table.left_out, name, &Channels::LeftOut::name) == table.left_out.end())
      table.left_out.push_back({name, "is no recording"});
    while (!is_mark(in.take())) {
    }
  }
  return sets;
}

/// Reason why a set is not a signal that fits the first one; empty where it is.
std::string why_left_out(const Set& set, const Set* first) {
  constexpr int time = 17;
  if (set.function > 1) return fmt::format("is no time history, but a function of type {}", set.function);
  if (set.complex()) return "is complex";
  if (set.abscissa_kind != 0 && set.abscissa_kind != time) return "has an abscissa that is no time";
  if (set.points < 2) return "has fewer than two readings";
  if (first == nullptr) return "";
  if (set.points != first->points)
    return fmt::format("has {} readings instead of {}", set.points, first->points);
  const double step = (first->times.back() - first->times.front()) / static_cast<double>(first->points - 1);
  for (std::size_t k = 0; k < set.points; ++k)
    if (!(std::abs(set.times[k] - first->times[k]) < std::abs(step) / 2)) return "has other times";
  return "";
}

/// Readings per second for a step with six digits: a whole number if one agrees with these digits.
double rate_of(double step_s) {
  constexpr double six_digits = 5e-6;
  const double rate = 1 / step_s, whole = std::round(rate);
  return whole > 0 && std::abs(rate - whole) < six_digits * rate ? whole : rate;
}

void add_time_histories(const std::vector<Set>& sets, Channels& table) {
  constexpr std::size_t most_sets = 4096;
  if (sets.size() > most_sets) throw Fault{1, 1, "has more than 4096 data sets", "fewer"};
  const Set* first = nullptr;
  std::vector<std::string> names;
  for (const Set& set : sets) {
    const auto same = std::ranges::count_if(sets, [&](const Set& other) { return other.title == set.title; });
    std::string name = set.title;
    if (name.empty() || same > 1) name += (name.empty() ? "" : " ") + set.point;
    const auto before = std::ranges::count(names, name);
    names.push_back(name);
    if (before > 0) name += fmt::format(" ({})", before + 1);
    if (std::string why = why_left_out(set, first); !why.empty()) {
      table.left_out.push_back({name, std::move(why)});
      continue;
    }
    if (first == nullptr) {
      first = &set;
      table.channels.push_back({"time", set.time_unit.empty() ? "s" : set.time_unit, set.times});
    }
    table.channels.push_back({name, set.unit, set.values});
  }
  if (first == nullptr || !first->even || table.channels.front().unit != "s") return;
  table.sampling_rate_hz = rate_of(first->step);
  for (std::size_t k = 0; k < first->points; ++k)
    table.channels.front().values[k] = first->begin + static_cast<double>(k) / *table.sampling_rate_hz;
}

}  // namespace

bool is_universal_file(std::string_view bytes) {
  std::string_view rest = bytes.substr(0, 1000);
  std::string_view line;
  while (!rest.empty() && trimmed(line).empty()) line = table::take_line(rest);
  if (!is_mark(line) || rest.empty()) return false;
  const std::string_view next = table::take_line(rest), kind = trimmed(next.substr(0, 7));
  const bool in_columns = line.starts_with("    -1") && !kind.empty();
  return kind == "58" || kind == "58b" ||
         (in_columns && kind.find_first_not_of("0123456789") == std::string_view::npos);
}

Channels read_universal_file(std::string_view bytes, const std::string& name) {
  Channels table;
  try {
    add_time_histories(read_sets(bytes, table), table);
  } catch (const Fault& fault) {
    throw ConfigError(
        fmt::format("{}:{}:{}: {}, allowed: {}", name, fault.line, fault.column, fault.wrong, fault.allowed));
  } catch (const matlab::FileError& error) {
    throw ConfigError(fmt::format("{}: {}, allowed: {}", name, error.wrong, allowed_set));
  }
  if (table.channels.empty())
    throw ConfigError(fmt::format("{}: holds no signal{}, allowed: time histories, data sets 58 or 58b", name,
                                  table.left_out_text()));
  return table;
}

}  // namespace rubsweep::recording
