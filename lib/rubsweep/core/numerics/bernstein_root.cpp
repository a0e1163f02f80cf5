#include "rubsweep/core/numerics/bernstein_root.hpp"

#include <algorithm>

namespace rubsweep::numerics {
namespace {

constexpr double resolution = 1e-12;

/// De Casteljau at the middle.
std::array<Quartic, 2> halves(const Quartic& q) {
  Quartic left{}, right{}, row = q;
  for (std::size_t level = 0; level < q.size(); ++level) {
    left[level] = row[0];
    right[q.size() - 1 - level] = row[q.size() - 1 - level];
    for (std::size_t i = 0; i + 1 < q.size() - level; ++i) row[i] = (row[i] + row[i + 1]) / 2;
  }
  return {left, right};
}

/// Searches [low, low + width]; `below` says whether the curve was below zero just before, and is carried
/// along.
std::optional<double> search(const Quartic& q, double low, double width, bool& below) {
  const auto [smallest, largest] = std::minmax_element(q.begin(), q.end());
  if (*largest < 0) {
    below = true;
    return std::nullopt;
  }
  if (*smallest >= 0) return below ? std::optional(low) : std::nullopt;
  if (width < resolution) {
    const bool was_below = below || q.front() < 0;
    below = q.back() < 0;
    return was_below && !below ? std::optional(low + width) : std::nullopt;
  }
  const auto [left, right] = halves(q);
  if (const auto found = search(left, low, width / 2, below)) return found;
  return search(right, low + width / 2, width / 2, below);
}

}  // namespace

Quartic quartic_through(double start, double start_slope, double middle, double end, double end_slope) {
  const double second = start + start_slope / 4;
  const double fourth = end - end_slope / 4;
  // B(1/2) = (c0 + 4 c1 + 6 c2 + 4 c3 + c4) / 16.
  return {start, second, (16 * middle - start - 4 * second - 4 * fourth - end) / 6, fourth, end};
}

bool clearly_below_zero(double start, double start_slope, double end, double end_slope) {
  const auto [low, high] = std::minmax({start, start + start_slope / 3, end - end_slope / 3, end});
  return high < -0.25 * (high - low);
}

std::optional<double> bernstein_root(const Quartic& quartic) {
  bool below = quartic.front() < 0;
  return search(quartic, 0, 1, below);
}

}  // namespace rubsweep::numerics
