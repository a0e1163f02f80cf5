#include "rubsweep/measurement/recording/probe_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace rubsweep::recording {
namespace {

/// Range of the readings (largest minus smallest) in every turn; NaN where a reading is missing.
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

/// Usual range of a turn while the probe moves: the 90th percentile of all ranges.
double usual_range(const std::vector<double>& ranges) {
  std::vector<double> finite;
  for (const double range : ranges)
    if (std::isfinite(range)) finite.push_back(range);
  if (finite.empty()) return 0;
  const auto place = finite.begin() + static_cast<std::ptrdiff_t>(finite.size() * 9 / 10);
  std::ranges::nth_element(finite, place);
  return *place;
}

/// Whether the autocorrelation of a signal does not exceed that of white noise of the same length.
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

/// Whether the second signal is a multiple of the first plus an offset, up to rounding.
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

constexpr std::size_t reach = 3, fewest_readings = 32, most_in_a_row = 3;
constexpr double far_off = 3, beyond_neighbours = 0.25, times_the_usual = 15, most_share = 0.02;

/// Value at `place` of the polynomial through three readings before and three readings after a group of
/// `count` readings; NaN where one of these six is missing.
double between_neighbours(const std::vector<double>& readings, std::size_t first, std::size_t count,
                          std::size_t place) {
  std::array<std::size_t, 2 * reach> at{};
  for (std::size_t i = 0; i < reach; ++i) {
    at[i] = first - reach + i;
    at[reach + i] = first + count + i;
  }
  double sum = 0;
  for (const std::size_t a : at) {
    double weight = 1;
    for (const std::size_t b : at)
      if (a != b)
        weight *= (static_cast<double>(place) - static_cast<double>(b)) /
                  (static_cast<double>(a) - static_cast<double>(b));
    sum += weight * readings[a];
  }
  return sum;
}

double quantile(std::vector<double>& values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

/// Interval that contains nine tenths of the readings.
struct Span {
  double low = 0, high = 0;

  double length() const { return high - low; }
  bool is_far(double value) const { return std::abs(value - (low + high) / 2) > far_off * length(); }
};

/// Median distance of the readings about a place from the polynomials through their neighbours. Polynomials
/// that use the suspected readings are left out.
double usual_distance(const std::vector<double>& readings, std::size_t first, std::size_t count) {
  constexpr std::size_t about = 24;
  std::vector<double> distances;
  const std::size_t from = std::max(first, about + reach) - about,
                    to = std::min(first + about, readings.size() - reach);
  for (std::size_t k = from; k < to; ++k) {
    if (k + reach >= first && k < first + count + reach) continue;
    const double distance = std::abs(readings[k] - between_neighbours(readings, k, 1, k));
    if (std::isfinite(distance)) distances.push_back(distance);
  }
  return distances.empty() ? INFINITY : quantile(distances, 0.5);
}

/// Whether each reading of a group is farther off its polynomial than usual for its surroundings, and by more
/// than `least`.
bool is_off(const std::vector<double>& readings, std::size_t first, std::size_t count, double least) {
  if (first < reach || first + count + reach > readings.size()) return false;
  const double most = std::max(least, times_the_usual * usual_distance(readings, first, count));
  for (std::size_t k = first; k < first + count; ++k)
    if (!(std::abs(readings[k] - between_neighbours(readings, first, count, k)) > most)) return false;
  return true;
}

void replace(std::vector<double>& readings, std::size_t first, std::size_t count,
             std::vector<std::size_t>& places) {
  for (std::size_t k = first; k < first + count; ++k) {
    readings[k] = between_neighbours(readings, first, count, k);
    places.push_back(k);
  }
}

/// Replaces groups of one to three readings far outside the usual interval.
void replace_far(std::vector<double>& readings, const Span& span, std::vector<std::size_t>& places) {
  for (std::size_t first = 0, end = 0; first < readings.size(); first = end + 1) {
    end = first;
    while (end < readings.size() && span.is_far(readings[end])) ++end;
    const std::size_t count = end - first;
    if (count > 0 && count <= most_in_a_row && is_off(readings, first, count, far_off / 2 * span.length()))
      replace(readings, first, count, places);
  }
}

/// Replaces single readings that exceed both neighbours, the worst first.
void replace_single(std::vector<double>& readings, const Span& span, std::vector<std::size_t>& places) {
  const double step = beyond_neighbours * span.length();
  std::vector<std::size_t> candidates;
  for (std::size_t k = reach; k + reach < readings.size(); ++k) {
    const double left = readings[k] - readings[k - 1], right = readings[k] - readings[k + 1];
    if (left * right > 0 && std::min(std::abs(left), std::abs(right)) > step) candidates.push_back(k);
  }
  std::ranges::sort(candidates, std::greater{}, [&](std::size_t k) {
    return std::min(std::abs(readings[k] - readings[k - 1]), std::abs(readings[k] - readings[k + 1]));
  });
  for (const std::size_t k : candidates)
    if (is_off(readings, k, 1, step)) replace(readings, k, 1, places);
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
  // Stretches are found in whole turns; the readings around both ends are searched for the exact ends.
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
                  "shaft, if that probe has no signal",
                  silent.column, seeing.column));
}

WildReadings replace_wild_readings(std::vector<double>& readings) {
  std::vector<double> finite;
  std::ranges::copy_if(readings, std::back_inserter(finite),
                       [](double value) { return std::isfinite(value); });
  if (finite.size() < fewest_readings) return {};
  const Span span{quantile(finite, 0.05), quantile(finite, 0.95)};
  if (!(span.length() > 0)) return {};
  WildReadings wild;
  std::vector<double> mended = readings;
  replace_far(mended, span, wild.places);
  replace_single(mended, span, wild.places);
  std::ranges::sort(wild.places);
  wild.replaced = static_cast<double>(wild.places.size()) <=
                  std::max(1.0, most_share * static_cast<double>(finite.size()));
  if (wild.replaced) readings = std::move(mended);
  return wild;
}

}  // namespace rubsweep::recording
