#include "rubsweep/core/numerics/polynomial_root.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::numerics {
namespace {

constexpr std::size_t most = most_degree + 1;
constexpr double resolution = 0x1p-44;
/// Number of terms tried first; they nearly always decide, because later terms of a long series are small.
constexpr std::size_t first_terms = 13, worth_while = 20;

/// Bernstein coefficients over an interval; only the first `count` are used.
struct Hull {
  std::array<double, most> b;
  std::size_t count = 0;
};

/// 1 / binomial(n, k), row by row.
constexpr auto inverse_binomials = [] {
  std::array<std::array<double, most>, most> table{};
  for (std::size_t n = 0; n < most; ++n) {
    double binomial = 1;
    for (std::size_t k = 0; k <= n; ++k) {
      table[n][k] = 1 / binomial;
      binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
  }
  return table;
}();

/// b_i = sum_k binomial(i, k) / binomial(n, k) c_k: all weights lie between 0 and 1.
Hull hull_of(std::span<const double> c) {
  Hull hull;
  hull.count = c.size();
  const auto& weights = inverse_binomials[c.size() - 1];
  for (std::size_t k = 0; k < c.size(); ++k) hull.b[k] = c[k] * weights[k];
  for (std::size_t level = 1; level < c.size(); ++level) {
    for (std::size_t i = c.size() - 1; i >= level; --i) hull.b[i] += hull.b[i - 1];
  }
  return hull;
}

/// De Casteljau's algorithm at the middle.
std::pair<Hull, Hull> halves(const Hull& hull) {
  Hull left, right, row = hull;
  left.count = right.count = hull.count;
  for (std::size_t level = 0; level < hull.count; ++level) {
    left.b[level] = row.b[0];
    right.b[hull.count - 1 - level] = row.b[hull.count - 1 - level];
    for (std::size_t i = 0; i + 1 < hull.count - level; ++i) row.b[i] = (row.b[i] + row.b[i + 1]) / 2;
  }
  return {left, right};
}

/// Number of sign changes of the coefficients (zero counts as positive), counted up to two.
int sign_changes(const Hull& hull) {
  int changes = 0;
  for (std::size_t i = 1; i < hull.count && changes < 2; ++i)
    changes += (hull.b[i - 1] < 0) != (hull.b[i] < 0);
  return changes;
}

/// Local parabola of a polynomial at one place: value, first derivative and half of the second derivative.
struct Parabola {
  double value = 0, slope = 0, bend = 0;
};

Parabola parabola_at(std::span<const double> c, double x) {
  Parabola at;
  for (std::size_t k = c.size(); k-- > 0;) {
    at.bend = at.bend * x + at.slope;
    at.slope = at.slope * x + at.value;
    at.value = at.value * x + c[k];
  }
  return at;
}

double halley_step(const Parabola& at) {
  return -at.value * at.slope / (at.slope * at.slope - at.value * at.bend);
}

/// Start value near the single root between `low` and `high`: zero of the chord, improved with only the first
/// terms, which cost half as much as all terms.
double near_root(std::span<const double> c, double low, double high, double at_low, double at_high) {
  double x = low + (high - low) * (at_low / (at_low - at_high));
  for (int i = 0; i < 2 && c.size() >= worth_while; ++i)
    x += halley_step(parabola_at(c.first(first_terms), x));
  return x > low && x < high ? x : (low + high) / 2;
}

/// Refines the single root between `low`, where the polynomial is negative, and `high` by Halley's iteration.
double refine(std::span<const double> c, double low, double high, double at_low, double at_high) {
  constexpr int most_iterations = 80;
  // Step size, relative to the root and the change of the slope, below which the remaining error is rounding.
  constexpr double small = 0x1p-20;
  double x = near_root(c, low, high, at_low, at_high);
  for (int i = 0; i < most_iterations; ++i) {
    const Parabola at = parabola_at(c, x);
    (at.value < 0 ? low : high) = x;
    const double halley = x + halley_step(at);
    const double next = halley > low && halley < high ? halley : (low + high) / 2;
    const double step = std::abs(next - x);
    if (step <= 0x1p-53 * x || !(low < high)) return next;
    if (next == halley && step <= small * x && step * std::abs(at.bend) <= small * std::abs(at.slope))
      return next;
    x = next;
  }
  return x;
}

/// First rise in [low, low + width]. Neighbouring intervals share their end value bit by bit, so that no rise
/// is lost between them.
std::optional<double> search(std::span<const double> c, const Hull& hull, double low, double width) {
  const bool starts_below = hull.b[0] < 0, ends_below = hull.b[hull.count - 1] < 0;
  const int changes = sign_changes(hull);
  if (changes == 0) return std::nullopt;
  if (changes == 1) {
    if (!starts_below) return std::nullopt;
    return refine(c, low, low + width, hull.b[0], hull.b[hull.count - 1]);
  }
  if (width < resolution) return starts_below && !ends_below ? std::optional(low + width) : std::nullopt;
  const auto [left, right] = halves(hull);
  if (const auto found = search(c, left, low, width / 2)) return found;
  return search(c, right, low + width / 2, width / 2);
}

/// Sum of the positive terms, in independent partial sums.
double sum_of_positive(std::span<const double> c) {
  const Twin zero{};
  Twin sums[2]{};
  std::size_t k = 0;
  for (; k + 4 <= c.size(); k += 4) {
    sums[0] += larger(zero, load(&c[k]));
    sums[1] += larger(zero, load(&c[k + 2]));
  }
  sums[0] += sums[1];
  double sum = sums[0][0] + sums[0][1];
  for (; k < c.size(); ++k) sum += std::max(0.0, c[k]);
  return sum;
}

/// Whether the polynomial is negative by the Bernstein form of its first terms and a bound of the other
/// terms. The cost of the Bernstein form is quadratic in the degree.
bool low_part_negative(std::span<const double> c) {
  if (c.size() < worth_while) return false;
  const double rest = sum_of_positive(c.subspan(first_terms));
  const Hull hull = hull_of(c.first(first_terms));
  return *std::max_element(hull.b.begin(), hull.b.begin() + first_terms) + rest < 0;
}

/// p(1), with even and odd terms summed separately.
double value_at_one(std::span<const double> c) {
  double even = 0, odd = 0;
  std::size_t k = 0;
  for (; k + 1 < c.size(); k += 2) {
    even += c[k];
    odd += c[k + 1];
  }
  return (k < c.size() ? even + c[k] : even) + odd;
}

/// For a polynomial that starts below zero and ends above it: whether it has a single root because it rises
/// everywhere or its second derivative keeps its sign.
bool clearly_one_root(std::span<const double> c) {
  std::array<double, most> falls, bends;  // -p', then p'' or -p''
  const std::size_t slopes = c.size() - 1;
  for (std::size_t k = 0; k < slopes; ++k) falls[k] = -static_cast<double>(k + 1) * c[k + 1];
  if (clearly_negative(std::span(falls).first(slopes))) return true;
  if (slopes < 2) return false;
  const double sign = falls[1] < 0 ? -1 : 1;
  for (std::size_t k = 0; k + 1 < slopes; ++k) bends[k] = -sign * static_cast<double>(k + 1) * falls[k + 1];
  return clearly_negative(std::span(bends).first(slopes - 1));
}

constexpr double finest_piece = 1e-12;

/// De Casteljau's algorithm at the middle.
std::array<Quartic, 2> halves(const Quartic& q) {
  Quartic left{}, right{}, row = q;
  for (std::size_t level = 0; level < q.size(); ++level) {
    left[level] = row[0];
    right[q.size() - 1 - level] = row[q.size() - 1 - level];
    for (std::size_t i = 0; i + 1 < q.size() - level; ++i) row[i] = (row[i] + row[i + 1]) / 2;
  }
  return {left, right};
}

/// Searches [low, low + width] for the first rise. `below`: whether the curve was below zero just before;
/// updated by the search.
std::optional<double> search(const Quartic& q, double low, double width, bool& below) {
  const auto [smallest, largest] = std::minmax_element(q.begin(), q.end());
  if (*largest < 0) {
    below = true;
    return std::nullopt;
  }
  if (*smallest >= 0) return below ? std::optional(low) : std::nullopt;
  if (width < finest_piece) {
    const bool was_below = below || q.front() < 0;
    below = q.back() < 0;
    return was_below && !below ? std::optional(low + width) : std::nullopt;
  }
  const auto [left, right] = halves(q);
  if (const auto found = search(left, low, width / 2, below)) return found;
  return search(right, low + width / 2, width / 2, below);
}

}  // namespace

bool clearly_negative(std::span<const double> c) {
  if (!(c[0] < 0)) return false;
  const double rest = c.size() > 4 ? sum_of_positive(c.subspan(4)) : 0;
  const auto coefficient = [&](std::size_t k) { return k < c.size() ? c[k] : 0.0; };
  const double c1 = coefficient(1), c2 = coefficient(2), c3 = coefficient(3);
  // The cubic part is at most its largest control ordinate, and no power of x exceeds one.
  const double highest = std::max({c[0], c[0] + c1 / 3, c[0] + 2 * c1 / 3 + c2 / 3, c[0] + c1 + c2 + c3});
  return highest + rest < 0;
}

std::optional<double> first_rise_of(std::span<const double> c, double noise) {
  if (c.empty() || clearly_negative(c)) return std::nullopt;
  if (c.size() > 1 && std::abs(c[0]) <= noise && c[1] < 0) {
    if (clearly_negative(c.subspan(1))) return std::nullopt;
    c = c.subspan(1);
  }
  const double end = value_at_one(c);
  if (c[0] < 0 && end > 0) {
    if (clearly_one_root(c)) return refine(c, 0, 1, c[0], end);
  } else if (low_part_negative(c)) {
    return std::nullopt;
  }
  return search(c, hull_of(c), 0, 1);
}

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
