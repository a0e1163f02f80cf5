#include "rubsweep/measurement/recording/probe_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rubsweep::recording {
namespace {

/// Difference of the largest and the smallest reading of every turn; NaN where a reading is missing.
std::vector<double> ranges_of(std::span<const double> values, std::size_t turn) {
  std::vector<double> ranges;
  for (std::size_t first = 0; first + turn <= values.size(); first += turn) {
    const auto readings = values.subspan(first, turn);
    const bool whole = std::ranges::all_of(readings, [](double value) { return std::isfinite(value); });
    const auto [low, high] = std::ranges::minmax(readings);
    ranges.push_back(whole ? high - low : NAN);
  }
  return ranges;
}

/// Range of a turn in which the probe moves: nine tenths of all are not larger.
double usual_range(const std::vector<double>& ranges) {
  std::vector<double> finite;
  for (const double range : ranges)
    if (std::isfinite(range)) finite.push_back(range);
  if (finite.empty()) return 0;
  const auto place = finite.begin() + static_cast<std::ptrdiff_t>(finite.size() * 9 / 10);
  std::ranges::nth_element(finite, place);
  return *place;
}

/// Whether a signal has no correlation with itself some readings later, beyond that of as many readings of
/// noise.
bool is_noise(std::span<const double> values) {
  constexpr std::size_t most_later = 64, fewest = 64;
  constexpr double many_deviations = 4.5;
  double mean = 0, count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    mean += value;
    ++count;
  }
  mean /= count;
  const auto product = [&](std::size_t later) {
    double sum = 0;
    for (std::size_t k = 0; k + later < values.size(); ++k)
      if (const double part = (values[k] - mean) * (values[k + later] - mean); std::isfinite(part))
        sum += part;
    return sum;
  };
  const double square = product(0);
  if (!(count >= fewest && square > 0)) return false;
  for (std::size_t later = 1; later <= most_later; ++later)
    if (!(std::abs(product(later)) < many_deviations * square / std::sqrt(count))) return false;
  return true;
}

/// Whether the second signal is the first one times a factor, plus an offset, but for rounding.
bool read_the_same(std::span<const double> a, std::span<const double> b) {
  constexpr double rounding = 1e-4;
  double count = 0, mean_a = 0, mean_b = 0, aa = 0, ab = 0, bb = 0;
  const auto each = [&](auto look) {
    for (std::size_t k = 0; k < a.size(); ++k)
      if (std::isfinite(a[k] + b[k])) look(a[k], b[k]);
  };
  each([&](double x, double y) {
    ++count;
    mean_a += x;
    mean_b += y;
  });
  mean_a /= count;
  mean_b /= count;
  each([&](double x, double y) {
    aa += (x - mean_a) * (x - mean_a);
    ab += (x - mean_a) * (y - mean_b);
    bb += (y - mean_b) * (y - mean_b);
  });
  return aa > 0 && bb > 0 && aa * bb - ab * ab < rounding * rounding * aa * bb;
}

}  // namespace

std::optional<Stretch> still_stretch(std::span<const double> values, std::span<const double> other,
                                     double readings_per_turn) {
  constexpr double still_share = 0.05, moving_share = 0.25;
  constexpr std::size_t fewest_turns = 2;
  const auto turn = static_cast<std::size_t>(std::ceil(readings_per_turn));
  const std::vector<double> ranges = ranges_of(values, turn), others = ranges_of(other, turn);
  const double usual = usual_range(ranges), usual_other = usual_range(others);
  if (!(usual > 0)) return std::nullopt;
  const auto is_still = [&](std::size_t k) {
    return others.empty() ? ranges[k] == 0
                          : ranges[k] <= still_share * usual && others[k] > moving_share * usual_other;
  };
  Stretch best;
  for (std::size_t first = 0, end = 0; first < ranges.size(); first = end + 1) {
    end = first;
    while (end < ranges.size() && is_still(end)) ++end;
    if (end - first > best.count) best = {first, end - first};
  }
  if (best.count < fewest_turns || best.count == ranges.size()) return std::nullopt;
  // The turns at both ends are still in part.
  std::size_t first = best.first * turn, end = first + best.count * turn;
  const double level = values[first], least = still_share * usual;
  while (first > 0 && std::abs(values[first - 1] - level) <= least) --first;
  while (end < values.size() && std::abs(values[end] - level) <= least) ++end;
  return Stretch{first, end - first};
}

void add_pair_findings(const ProbeReadings& first, const ProbeReadings& second,
                       std::vector<std::string>& findings) {
  if (read_the_same(first.values, second.values)) {
    findings.push_back(
        fmt::format("'{}' and '{}' read the same signal: one probe at two inputs, or a motion along one line "
                    "without any noise",
                    first.column, second.column));
    return;
  }
  const bool noise = is_noise(first.values), other_noise = is_noise(second.values);
  if (noise == other_noise) return;
  const auto& [silent, seeing] = noise ? std::pair(first, second) : std::pair(second, first);
  findings.push_back(
      fmt::format("'{}' shows noise alone where '{}' sees a motion: shape and whirl are not those of the "
                  "shaft, if that probe has no "
                  "signal",
                  silent.column, seeing.column));
}

}  // namespace rubsweep::recording
