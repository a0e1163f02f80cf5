#include "rubscope/column_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "rubsweep/maps/table/unit.hpp"

namespace rubsweep::apps {

using namespace recording;

namespace {

constexpr std::size_t shown_values = 3;

/// Step of values that rise evenly, as times do.
std::optional<double> even_step(const std::vector<double>& values) {
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  if (!(step > 0) || values.size() < 3) return std::nullopt;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(std::abs(values[k] - values[0] - step * static_cast<double>(k)) < step / 2)) return std::nullopt;
  return step;
}

/// True for a column of times, or one without a unit, which may be one.
bool may_be_times(const Channel& channel) {
  const auto unit = table::unit_of(channel.unit);
  return channel.unit.empty() || (unit && unit->quantity == table::Quantity::time);
}

std::string unit_text(const Channel& channel) { return channel.unit.empty() ? "-" : channel.unit; }

std::string range_text(const Channel& channel) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : channel.values) {
    low = std::fmin(low, value);
    high = std::fmax(high, value);
  }
  return low > high ? "no number" : fmt::format("{:.6g} to {:.6g}", low, high);
}

std::string first_values(const Channel& channel) {
  std::string text;
  for (std::size_t k = 0; k < std::min(shown_values, channel.values.size()); ++k)
    text += fmt::format("{}{:.8g}", k > 0 ? ", " : "", channel.values[k]);
  return text + (channel.values.size() > shown_values ? ", ..." : "");
}

std::string clock_text(const Channels& channels) {
  std::string text;
  if (channels.sampling_rate_hz)
    text = fmt::format("clock     {:.8g} readings a second, as the file says\n", *channels.sampling_rate_hz);
  for (const Channel& channel : channels.channels)
    if (const auto step = may_be_times(channel) ? even_step(channel.values) : std::nullopt)
      text += fmt::format("clock     '{}' rises evenly, by {:.8g}{}\n", channel.name, *step,
                          channel.unit.empty() ? "" : ' ' + channel.unit);
  if (text.empty())
    text =
        "clock     none: no column rises evenly; give sampling_rate_hz in the description, or the column of "
        "times\n";
  return text;
}

}  // namespace

std::string column_list(const Channels& channels, const std::string& name) {
  std::string text =
      fmt::format("{}: {} columns of {} readings, from {} to {}\n", name, channels.channels.size(),
                  channels.rows(), channels.place_of(0), channels.place_of(channels.rows() - 1));
  text += clock_text(channels);
  std::size_t widest = 4, widest_unit = 4;
  for (const Channel& channel : channels.channels) {
    widest = std::max(widest, channel.name.size());
    widest_unit = std::max(widest_unit, unit_text(channel).size());
  }
  text += fmt::format("{:>6}  {:{}}  {:{}}  {:28}  {}\n", "number", "name", widest, "unit", widest_unit,
                      "range", "first values");
  bool without_unit = false;
  for (std::size_t i = 0; i < channels.channels.size(); ++i) {
    const Channel& channel = channels.channels[i];
    without_unit = without_unit || channel.unit.empty();
    text += fmt::format("{:>6}  {:{}}  {:{}}  {:28}  {}\n", channel.number > 0 ? channel.number : i + 1,
                        channel.name, widest, unit_text(channel), widest_unit, range_text(channel),
                        first_values(channel));
  }
  for (const Channels::LeftOut& one : channels.left_out)
    text += fmt::format("left out  '{}' {}\n", one.name, one.why);
  for (const std::string& note : channels.notes) text += "note      " + note + '\n';
  if (without_unit) text += "unit      a probe whose column has none takes `unit: um` in the description\n";
  text += "names     in the description: as above, or 'column 2' by the number\n";
  return text;
}

}  // namespace rubsweep::apps
