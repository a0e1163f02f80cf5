#include "rubsweep/measurement/recording/labview_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/maps/table/layout.hpp"
#include "rubsweep/maps/table/time_stamp.hpp"
#include "rubsweep/measurement/recording/delimited_text.hpp"

namespace rubsweep::recording {
namespace {

using table::Fault;

constexpr std::string_view times_name = "X_Value";

/// A head with its rows.
struct Segment {
  std::string_view text;
  std::size_t lines_before = 0;
};

std::vector<Segment> segments_of(std::string_view text) {
  std::vector<Segment> segments;
  const char* begin = text.data();
  std::size_t line = 0, first_line = 0;
  bool rows = false;
  const auto end_segment = [&](const char* end) {
    segments.push_back({{begin, static_cast<std::size_t>(end - begin)}, first_line});
  };
  while (!text.empty()) {
    const char* const here = text.data();
    const std::string_view cells = table::take_line(text);
    if (rows && cells.starts_with("Channels")) {
      end_segment(here);
      begin = here;
      first_line = line;
      rows = false;
    }
    const bool names = cells.starts_with(times_name);
    if (names && rows)
      throw Fault{line + 1, 1, "begins another segment of LabVIEW without its head",
                  "a head for each segment"};
    rows = rows || names;
    ++line;
  }
  end_segment(text.data());
  return segments;
}

/// Lines of a header by their keys, up to the names of the signals.
class Head {
 public:
  explicit Head(std::string_view text)
      : text_(text), separator_(text.find('\t') < text.find(times_name) ? '\t' : ',') {}

  /// Cells behind `key` in the last line that begins with it, because the header of a segment stands below
  /// that of the file. The last line of all has the key X_Value: the names of the signals.
  std::vector<std::string_view> cells(std::string_view key) const {
    std::vector<std::string_view> found;
    for (std::string_view rest = text_; !rest.empty();) {
      auto cells = table::cells_of(table::take_line(rest), separator_);
      if (cells.front() == key) found = {cells.begin() + 1, cells.end()};
      if (cells.front() == times_name) break;
    }
    return found;
  }
  std::string_view word(std::string_view key) const {
    const auto all = cells(key);
    return all.empty() ? std::string_view() : all.front();
  }
  std::optional<double> number(std::string_view key) const {
    const std::string_view cell = word(key);
    for (const bool comma : {false, true})
      if (const auto value = table::number_in(cell, {separator_, comma}); value && std::isfinite(*value))
        return value;
    return std::nullopt;
  }
  /// Instant of the first reading: day and time of the day, in seconds, each with all its digits.
  std::optional<std::array<double, 2>> begin_s() const {
    const std::string midnight = std::string(word("Date")) + " 00:00:00";
    const auto day_s = table::time_stamp_in(midnight, {separator_});
    for (const bool comma : {false, true})
      if (const auto time_s = table::time_stamp_in(word("Time"), {separator_, comma}); time_s && day_s)
        return std::array{*day_s, *time_s};
    return std::nullopt;
  }

 private:
  std::string_view text_;
  char separator_;
};

bool is_times(const Channel& channel) { return channel.name == times_name; }

void shorten(Channels& table, std::size_t rows) {
  for (Channel& channel : table.channels) channel.values.resize(rows);
  table.line.resize(rows);
}

/// Replaces the times of all signals, which must be equal, by one column of times.
void join_times(Channels& table) {
  std::vector<const Channel*> times;
  for (const Channel& channel : table.channels)
    if (is_times(channel)) times.push_back(&channel);
  if (times.size() < 2) return;
  std::size_t rows = 0;
  while (rows < table.rows() &&
         std::ranges::all_of(times, [&](const Channel* one) { return std::isfinite(one->values[rows]); }))
    ++rows;
  if (rows < 2)
    throw Fault{table.line.front(), 1, "is the only row in which all signals have times", "two or more"};
  const auto& first = times.front()->values;
  const double step = (first[rows - 1] - first[0]) / static_cast<double>(rows - 1);
  for (const Channel* one : times)
    for (std::size_t k = 0; k < rows; ++k)
      if (!(std::abs(one->values[k] - first[k]) < std::abs(step) / 2))
        throw Fault{table.line[k], 1, "has other times for one signal than for the first, X_Columns Multi",
                    "signals of one clock, or each in a file of its own"};
  if (rows < table.rows())
    table.notes.push_back("signals have different lengths: the first " + std::to_string(rows) +
                          " readings, which all of them have, are looked at");
  shorten(table, rows);
  bool kept = false;
  std::erase_if(table.channels,
                [&](const Channel& one) { return is_times(one) && std::exchange(kept, true); });
}

/// Gives the signals the units of Y_Unit_Label. Where a name ends in brackets with another word, as in
/// `Response (Trigger)`, the word is no unit but part of the name.
void label_units(Channels& table, const Head& head) {
  const auto units = head.cells("Y_Unit_Label"), names = head.cells(times_name);
  for (Channel& channel : table.channels) {
    if (channel.number < 2 || channel.number >= units.size() + 2) continue;
    const std::string_view unit = units[channel.number - 2];
    if (unit.empty() || unit == channel.unit) continue;
    if (!channel.unit.empty() && channel.number - 2 < names.size()) channel.name = names[channel.number - 2];
    channel.unit = unit;
  }
}

/// Forgets the rate, which is 1 / Delta_X, where the times of the file do not keep to it: LabVIEW writes a
/// Delta_X of 1 s for readings that come when they come.
void forget_untrue_rate(Channels& table) {
  const auto times = std::ranges::find_if(table.channels, is_times);
  if (times == table.channels.end() || !table.sampling_rate_hz) return;
  const auto& values = times->values;
  const double step = 1 / *table.sampling_rate_hz;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(std::abs(values[k] - values[0] - step * static_cast<double>(k)) < step / 2)) {
      table.sampling_rate_hz.reset();
      return;
    }
}

/// Reads one segment: fills the column of times where it is empty, and gives units to the signals.
Channels read_segment(const Segment& segment) {
  Channels table;
  try {
    table = read_table(segment.text, segment.lines_before);
  } catch (Fault& fault) {
    fault.line += segment.lines_before;
    throw;
  }
  const Head head(segment.text);
  label_units(table, head);
  const auto step = head.number("Delta_X");
  for (const char* key : {"Delta_X", "X0"}) {
    const auto cells = head.cells(key);
    const auto other =
        std::ranges::find_if(cells, [&](auto cell) { return !cell.empty() && cell != cells.front(); });
    if (other == cells.end() || std::ranges::any_of(table.channels, is_times)) continue;
    const std::string_view above =
        segment.text.substr(0, static_cast<std::size_t>(other->data() - segment.text.data()));
    const auto lines = static_cast<std::size_t>(std::ranges::count(above, '\n'));
    throw Fault{segment.lines_before + lines + 1, above.size() - above.rfind('\n'),
                "has another " + std::string(key) + " for another signal",
                "one for all, or a column of times"};
  }
  if (std::ranges::none_of(table.channels, is_times) && step && *step > 0) {
    Channel times{std::string(times_name), "s", {}, 1};
    for (std::size_t k = 0; k < table.rows(); ++k)
      times.values.push_back(head.number("X0").value_or(0) + *step * static_cast<double>(k));
    table.channels.insert(table.channels.begin(), std::move(times));
    std::erase_if(table.left_out, [](const Channels::LeftOut& one) { return one.name == times_name; });
  }
  for (Channel& channel : table.channels)
    if (is_times(channel) && channel.unit.empty()) channel.unit = "s";
  join_times(table);
  forget_untrue_rate(table);
  return table;
}

/// Shift to be added to the times of a segment, so that they follow the times of the segments before.
double shift_of(const std::vector<double>& before, const std::vector<double>& next, const Segment& first,
                const Segment& segment) {
  if (next.front() > before.back()) return 0;
  const auto begin_s = Head(first.text).begin_s(), now_s = Head(segment.text).begin_s();
  const double shift = begin_s && now_s ? ((*now_s)[0] - (*begin_s)[0]) + ((*now_s)[1] - (*begin_s)[1]) : 0;
  if (!(next.front() + shift > before.back()))
    throw Fault{segment.lines_before + 1, 1, "begins another segment of LabVIEW, whose times do not follow",
                "segments that follow each other, or one in a file"};
  return shift;
}

}  // namespace

Channels read_labview_text(std::string_view text) {
  const std::vector<Segment> segments = segments_of(text);
  Channels all = read_segment(segments.front());
  for (std::size_t i = 1; i < segments.size(); ++i) {
    Channels next = read_segment(segments[i]);
    const auto same_name = [](const Channel& a, const Channel& b) {
      return a.name == b.name && a.unit == b.unit;
    };
    if (!std::ranges::equal(all.channels, next.channels, same_name))
      throw Fault{segments[i].lines_before + 1, 1, "begins a segment of LabVIEW with other signals",
                  "the same in all segments"};
    const auto times = std::ranges::find_if(all.channels, is_times);
    if (times == all.channels.end())
      throw Fault{segments[i].lines_before + 1, 1, "begins another segment of LabVIEW without times",
                  "X_Value, or Delta_X in the head"};
    const auto place = static_cast<std::size_t>(times - all.channels.begin());
    const double shift = shift_of(times->values, next.channels[place].values, segments.front(), segments[i]);
    for (double& t : next.channels[place].values) t += shift;
    for (std::size_t k = 0; k < all.channels.size(); ++k)
      all.channels[k].values.insert(all.channels[k].values.end(), next.channels[k].values.begin(),
                                    next.channels[k].values.end());
    all.line.insert(all.line.end(), next.line.begin(), next.line.end());
    all.notes.insert(all.notes.end(), next.notes.begin(), next.notes.end());
    // There may be gaps between segments, so only the column of times gives the clock.
    all.sampling_rate_hz.reset();
  }
  return all;
}

}  // namespace rubsweep::recording
