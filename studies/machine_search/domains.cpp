#include "machine_search/domains.hpp"

#include <algorithm>
#include <set>

namespace rubsweep::machine_search {
namespace {

constexpr double natural_frequency_hz = 30;
constexpr double gap_share = 0.2;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

bool has_order(const sweep::Row& row, int n) {
  return row.motion_class == response::motion::MotionClass::subharmonic && row.order == n;
}

}  // namespace

double speed_of(const sweep::Row& row) { return row.speed_hz / natural_frequency_hz; }

Domains::Domains(const Rows& map) : map_(&map) {
  std::set<double> ratios, speeds;
  for (const sweep::Row& row : map) {
    ratios.insert(row.whirl_ratio);
    speeds.insert(speed_of(row));
  }
  if (speeds.size() > 1)
    column_ = (*speeds.rbegin() - *speeds.begin()) / static_cast<double>(speeds.size() - 1);
  const std::vector<double> rows(ratios.begin(), ratios.end());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double up = i + 1 < rows.size() ? rows[i + 1] - rows[i] : 0,
                 down = i > 0 ? rows[i] - rows[i - 1] : 0;
    heights_[rows[i]] = i == 0 ? up : i + 1 == rows.size() ? down : (up + down) / 2;
  }
}

double Domains::area(const Condition& belongs) const {
  double sum = 0;
  for (const sweep::Row& row : *map_) {
    if (belongs(row)) sum += heights_.at(row.whirl_ratio);
  }
  return sum;
}

std::optional<double> Domains::share(const Condition& part, const Condition& whole) const {
  const double all = area(whole);
  if (all == 0) return std::nullopt;
  return area([&](const sweep::Row& row) { return whole(row) && part(row); }) / all;
}

std::optional<double> Domains::lean(const Condition& belongs) const {
  double weight = 0, x = 0, y = 0, low = 1e9, high = 0;
  for (const sweep::Row& row : *map_) {
    if (!belongs(row)) continue;
    const double height = heights_.at(row.whirl_ratio);
    weight += height;
    x += height * row.whirl_ratio;
    y += height * speed_of(row);
    low = std::min(low, row.whirl_ratio);
    high = std::max(high, row.whirl_ratio);
  }
  if (!(high > low)) return std::nullopt;
  double covariance = 0, variance = 0;
  for (const sweep::Row& row : *map_) {
    if (!belongs(row)) continue;
    const double height = heights_.at(row.whirl_ratio), dx = row.whirl_ratio - x / weight;
    covariance += height * dx * (speed_of(row) - y / weight);
    variance += height * dx * dx;
  }
  return covariance / variance * (high - low);
}

std::optional<double> Domains::least_ratio(const Condition& belongs) const {
  std::optional<double> least;
  for (const sweep::Row& row : *map_) {
    if (belongs(row)) least = std::min(least.value_or(row.whirl_ratio), row.whirl_ratio);
  }
  return least;
}

std::optional<double> Domains::median_speed(const Condition& belongs) const {
  std::vector<double> speeds;
  for (const sweep::Row& row : *map_) {
    if (belongs(row)) speeds.push_back(speed_of(row));
  }
  return speeds.empty() ? std::nullopt : std::optional(median(speeds));
}

std::optional<double> Domains::mean_width(const Condition& belongs, double low, double high) const {
  double height = 0;
  for (const auto& [ratio, one] : heights_) height += ratio >= low && ratio < high ? one : 0;
  if (height == 0) return std::nullopt;
  return column_ * area([&](const sweep::Row& row) {
           return row.whirl_ratio >= low && row.whirl_ratio < high && belongs(row);
         }) /
         height;
}

std::optional<double> Domains::parted_share(int n) const {
  double parted = 0, whole = 0;
  for (const auto& [ratio, height] : heights_) {
    std::vector<double> lower, upper;
    for (const sweep::Row& row : *map_) {
      if (row.whirl_ratio != ratio) continue;
      if (has_order(row, n)) lower.push_back(speed_of(row));
      if (has_order(row, n + 1)) upper.push_back(speed_of(row));
    }
    if (lower.empty() || upper.empty()) continue;
    const double low = median(lower), high = median(upper);
    double cells = 0, quiet = 0;
    for (const sweep::Row& row : *map_) {
      if (row.whirl_ratio != ratio || !(low < speed_of(row) && speed_of(row) < high)) continue;
      ++cells;
      quiet += row.motion_class == response::motion::MotionClass::non_contact;
    }
    whole += height;
    if (quiet >= gap_share * std::max(1.0, cells)) parted += height;
  }
  return whole == 0 ? std::nullopt : std::optional(parted / whole);
}

std::map<double, double> Domains::row_tops(const Condition& belongs) const {
  std::map<double, double> tops;
  for (const sweep::Row& row : *map_) {
    if (!belongs(row)) continue;
    double& top = tops[row.whirl_ratio];
    top = std::max(top, speed_of(row));
  }
  return tops;
}

double Domains::lowest_speed() const {
  double lowest = 1e9;
  for (const sweep::Row& row : *map_) lowest = std::min(lowest, speed_of(row));
  return lowest;
}

}  // namespace rubsweep::machine_search
