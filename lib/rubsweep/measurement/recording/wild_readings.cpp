#include "rubsweep/measurement/recording/wild_readings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace rubsweep::recording {
namespace {

constexpr std::size_t reach = 3, fewest_readings = 32, most_in_a_row = 3;
constexpr double far_off = 3, beyond_neighbours = 0.25, times_the_usual = 15, most_share = 0.02;

/// Polynomial through the three readings before a place and the three behind `count` readings from there on,
/// at one of these; NaN where one of the six is missing.
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

/// Where nine tenths of the readings are.
struct Span {
  double low = 0, high = 0;

  double length() const { return high - low; }
  bool is_far(double value) const { return std::abs(value - (low + high) / 2) > far_off * length(); }
};

/// Median distance of the readings about a place from the polynomials through their neighbours, without those
/// that see the readings in question.
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

/// Whether readings in a row are all farther off their neighbours than others about them, and than `least`.
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

/// Far readings, one to three in a row.
void replace_far(std::vector<double>& readings, const Span& span, std::vector<std::size_t>& places) {
  for (std::size_t first = 0, end = 0; first < readings.size(); first = end + 1) {
    end = first;
    while (end < readings.size() && span.is_far(readings[end])) ++end;
    const std::size_t count = end - first;
    if (count > 0 && count <= most_in_a_row && is_off(readings, first, count, far_off / 2 * span.length()))
      replace(readings, first, count, places);
  }
}

/// Single readings beyond both neighbours, from the farthest on.
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
