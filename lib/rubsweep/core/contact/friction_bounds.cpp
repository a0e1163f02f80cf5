#include "rubsweep/core/contact/friction_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

constexpr double points_per_decade = 32;
constexpr double linear_below = 1e-4, saturated_above = 40;  // arguments of tanh
constexpr double rounding = 1e-13;                           // share of the sum of all heights
constexpr int minimum_bits = 40;

/// Range of slip speeds outside which every tanh term is linear or saturated.
struct Span {
  double low = 0, high = 0;
};

Span span_of(const FrictionTerms& terms) {
  Span span{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < terms.count; ++i) {
    const double steepness = std::abs(terms.tanh[i].steepness_s_per_m);
    span.low = std::min(span.low, linear_below / steepness);
    span.high = std::max(span.high, saturated_above / steepness);
  }
  return span;
}

double heights(const FrictionTerms& terms) {
  double sum = std::abs(terms.constant);
  for (std::size_t i = 0; i < terms.count; ++i) sum += std::abs(terms.tanh[i].height);
  return sum;
}

/// Smallest value of `function` over the span, and its place: the best point of a grid with a fixed number of
/// points per decade, refined by Brent's method between its neighbours.
template <class Function>
std::pair<double, double> smallest(const Function& function, const Span& span) {
  const int steps = 1 + static_cast<int>(points_per_decade * std::log10(span.high / span.low));
  const auto speed = [&](int k) { return span.low * std::pow(span.high / span.low, double(k) / steps); };
  int best = 0;
  for (int k = 1; k <= steps; ++k) {
    if (function(speed(k)) < function(speed(best))) best = k;
  }
  const auto bottom = boost::math::tools::brent_find_minima(function, speed(std::max(0, best - 1)),
                                                            speed(std::min(steps, best + 1)), minimum_bits);
  const double at_best = function(speed(best));
  return bottom.second < at_best ? bottom : std::pair(speed(best), at_best);
}

}  // namespace

FrictionBounds friction_bounds(const model::Friction& friction) {
  const FrictionTerms terms = friction_terms(friction);
  FrictionBounds bounds;
  bounds.smallest = terms.constant + terms.dry;
  bounds.largest = terms.constant + terms.holding;
  Span span{1, 1};
  if (terms.count > 0) {
    span = span_of(terms);
    const auto whole = [&](double slip) { return friction_coefficient(friction, slip); };
    // The viscous part is left out here, not subtracted: subtracting such a large part would leave only
    // rounding errors.
    const auto fallen = [&](double slip) {
      double sum = terms.constant + terms.dry;
      for (std::size_t i = 0; i < terms.count; ++i)
        sum += terms.tanh[i].height * std::tanh(terms.tanh[i].steepness_s_per_m * slip);
      return -sum;
    };
    std::tie(bounds.smallest_at_m_per_s, bounds.smallest) = smallest(whole, span);
    bounds.largest = -smallest(fallen, span).second;
  }
  if (terms.viscous_s_per_m < 0) {
    bounds.smallest = -std::numeric_limits<double>::infinity();
    bounds.smallest_at_m_per_s = std::numeric_limits<double>::infinity();
  }
  if (bounds.smallest < 0 && bounds.smallest >= -rounding * heights(terms)) bounds.smallest = 0;
  return bounds;
}

bool brakes(const FrictionBounds& bounds) {
  return bounds.smallest >= 0 && bounds.largest <= model::ConstantFriction::coefficient_range.high;
}

void refuse_driving(const model::Friction& friction, const std::string& path) {
  const FrictionBounds bounds = friction_bounds(friction);
  if (brakes(bounds)) return;
  throw ConfigError(
      fmt::format("{}: a coefficient from {:.4g} to {:.4g}, allowed: one that is >= 0 at every "
                  "slip speed and, without its viscous part, <= {}",
                  path, bounds.smallest, bounds.largest, model::ConstantFriction::coefficient_range.high));
}

}  // namespace rubsweep::contact
