#include "rubsweep/measurement/recording/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>

#include "rubsweep/core/model/speed_text.hpp"

namespace rubsweep::recording {
namespace {

constexpr std::size_t fewest_equal = 5, fewest_times = 10;
/// The lowest or highest value counts as clipped if it has more than this many times the readings of any
/// other value. The top of a sine in a coarse converter has 2.4 times as many readings as the next value.
constexpr std::size_t times_as_often = 5;
constexpr double largest_change = 0.01;
constexpr double fewest_readings_of_a_turn = 20;

/// Distribution of the readings over their values.
struct Values {
  double low = INFINITY, high = -INFINITY;
  double step = INFINITY;  ///< smallest difference of two values: the step of the converter, if there is one
  std::size_t at_low = 0, at_high = 0;  ///< numbers of readings with the smallest and with the largest value
  std::size_t most_between = 0;         ///< number of readings of the most frequent value between these two
};

Values values_of(std::span<const double> readings) {
  std::vector<double> sorted;
  std::ranges::copy_if(readings, std::back_inserter(sorted),
                       [](double value) { return std::isfinite(value); });
  std::ranges::sort(sorted);
  Values values;
  if (sorted.empty()) return values;
  values.low = sorted.front();
  values.high = sorted.back();
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && sorted[end] == sorted[begin]) ++end;
    if (end < sorted.size()) values.step = std::fmin(values.step, sorted[end] - sorted[begin]);
    std::size_t& count = begin == 0             ? values.at_low
                         : end == sorted.size() ? values.at_high
                                                : values.most_between;
    count = std::max(count, end - begin);
  }
  return values;
}

/// Mean square of a signal in a narrow band; `share`: its frequency divided by half the sampling rate.
double energy_near(std::span<const double> readings, double share) {
  constexpr std::size_t block = 32;
  double energy = 0;
  std::size_t blocks = 0;
  for (std::size_t begin = 0; begin + block <= readings.size(); begin += block, ++blocks) {
    std::complex<double> sum = 0;
    double weights = 0;
    for (std::size_t k = 0; k < block; ++k) {
      // Hann window, so that the shaft's motion at far lower frequencies does not leak into the band.
      const double weight =
          1 - std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(block));
      sum += weight * readings[begin + k] *
             std::polar(1.0, -std::numbers::pi * share * static_cast<double>(begin + k));
      weights += weight;
    }
    const double square = std::norm(sum / weights);
    if (!std::isfinite(square)) continue;  // a gap
    energy += square;
  }
  return blocks > 0 ? energy / static_cast<double>(blocks) : 0;
}

/// Whether there is a strong line just below half the sampling rate, where an anti-aliasing filter would
/// remove everything.
bool vibrates_near_half_the_rate(std::span<const double> readings) {
  constexpr double many_times = 30;
  constexpr std::size_t fewest = 256, enough = 1 << 18;
  if (readings.size() < fewest) return false;
  if (readings.size() > enough) readings = readings.subspan((readings.size() - enough) / 2, enough);
  const double middle = std::max(energy_near(readings, 0.5), energy_near(readings, 0.7));
  return energy_near(readings, 0.95) > many_times * middle;
}

/// Whether readings are clipped at a value: they stay there for long, or return to it again and again while
/// no other value is `repeated`. Clipped readings reach the value by more than `step`; a rounded peak that a
/// coarse converter flattens is reached by a single step.
bool is_cut_at(std::span<const double> readings, double value, double step, bool repeated) {
  std::size_t times = 0;
  for (std::size_t k = 1; k < readings.size(); ++k) {
    if (readings[k] != value || std::isnan(readings[k - 1]) || readings[k - 1] == value) continue;
    if (std::abs(readings[k - 1] - value) <= step) continue;
    std::size_t end = k;
    while (end < readings.size() && readings[end] == value) ++end;
    if (end - k >= fewest_equal || (repeated && ++times >= fewest_times)) return true;
  }
  return false;
}

/// Root mean square distance of the marks from the cubic through two neighbours on either side, divided by
/// the interval of marks.
double off_neighbours(std::span<const double> marks_s) {
  double squares = 0, count = 0;
  for (std::size_t k = 2; k + 2 < marks_s.size(); ++k) {
    const double between = (4 * (marks_s[k - 1] + marks_s[k + 1]) - marks_s[k - 2] - marks_s[k + 2]) / 6;
    const double interval = (marks_s[k + 1] - marks_s[k - 1]) / 2;
    squares += (marks_s[k] - between) * (marks_s[k] - between) / (interval * interval);
    ++count;
  }
  return count > 0 ? std::sqrt(squares / count) : 0;
}

}  // namespace

void add_findings(const Channel& channel, const Channels& table, std::optional<double> full_scale,
                  std::vector<std::string>& findings) {
  const std::vector<double>& readings = channel.values;
  const std::string& column = channel.name;
  const auto is_gap = [](double value) { return std::isnan(value); };
  if (const auto gaps = std::ranges::count_if(readings, is_gap); gaps > 0) {
    const auto first = static_cast<std::size_t>(std::ranges::find_if(readings, is_gap) - readings.begin());
    findings.push_back(fmt::format("'{}' has gaps: {} readings are missing, the first one in {}", column,
                                   gaps, table.place_of(first)));
  }
  const Values values = values_of(readings);
  if (!(values.low < values.high)) {
    findings.push_back(fmt::format("'{}' is dead: it reads one value all the time", column));
    return;
  }
  const double step = 2.5 * values.step;
  constexpr double nearly = 0.999;
  const bool low_repeated = values.at_low >= times_as_often * values.most_between,
             high_repeated = values.at_high >= times_as_often * values.most_between;
  const bool below = is_cut_at(readings, values.low, step, low_repeated) ||
                     (full_scale && values.low <= -nearly * *full_scale),
             above = is_cut_at(readings, values.high, step, high_repeated) ||
                     (full_scale && values.high >= nearly * *full_scale);
  if (below || above) {
    findings.push_back(fmt::format("'{}' is clipped {}", column,
                                   below && above ? "at both ends of its range"
                                   : below        ? "below"
                                                  : "above"));
  }
  if (vibrates_near_half_the_rate(readings))
    findings.push_back(
        fmt::format("'{}' vibrates just below half the sampling rate: what vibrates above that is folded to "
                    "other orders (aliasing), and a filter or a higher rate would keep it away",
                    column));
}

void add_wild_findings(const WildReadings& wild, const Channel& channel, const Channels& table,
                       std::vector<std::string>& findings) {
  if (wild.places.empty()) return;
  const std::string where = fmt::format("'{}' has {} wild readings, the first one in {}", channel.name,
                                        wild.places.size(), table.place_of(wild.places.front()));
  findings.push_back(where + (wild.replaced ? ": what their neighbours say stands in their place"
                                            : ": so many that none of them is replaced"));
}

void add_mark_findings(const TurnMarks& marks, const Keyphasor& keyphasor,
                       std::vector<std::string>& findings) {
  const std::string& column = keyphasor.column;
  const bool pulses = keyphasor.pulses_per_turn > 1;
  const char* const step = pulses ? "step" : "turn";
  if (marks.filled > 0) {
    constexpr double tiny = 1e-6;
    const double off = off_neighbours(marks.t_s);
    findings.push_back(fmt::format(
        "'{}' has no mark in {} {}s: they are taken to be like those beside them{}", column, marks.filled,
        step,
        off > tiny ? fmt::format(", whose marks follow from their neighbours to {:.2g} of a {}", off, step)
                   : ""));
  }
  if (marks.dropped > 0)
    findings.push_back(
        fmt::format("'{}' has {} marks too many, which are left out: a hysteresis would keep them away",
                    column, marks.dropped));
  if (pulses)
    findings.push_back(fmt::format(
        "'{}' has {} pulses a turn, and turns begin with the first one: phases are those of no other "
        "recording",
        column, keyphasor.pulses_per_turn));
}

void add_speed_findings(std::span<const double> turn_begin_s, double sampling_rate_hz,
                        std::vector<std::string>& findings) {
  for (std::size_t k = 2; k < turn_begin_s.size(); ++k) {
    const double before_s = turn_begin_s[k - 1] - turn_begin_s[k - 2],
                 now_s = turn_begin_s[k] - turn_begin_s[k - 1];
    if (std::abs(now_s - before_s) <= largest_change * before_s) continue;
    findings.push_back(fmt::format("the speed is unsteady: at {:.4g} s it goes from {} within a turn",
                                   turn_begin_s[k - 1], model::speed_range_text(1 / before_s, 1 / now_s, 5)));
    break;
  }
  const double mean_s =
      (turn_begin_s.back() - turn_begin_s.front()) / static_cast<double>(turn_begin_s.size() - 1);
  if (mean_s * sampling_rate_hz < fewest_readings_of_a_turn) {
    findings.push_back(fmt::format("{:.3g} readings a turn: motion above {:.3g}X is folded to other orders",
                                   mean_s * sampling_rate_hz, mean_s * sampling_rate_hz / 2));
  }
}

}  // namespace rubsweep::recording
