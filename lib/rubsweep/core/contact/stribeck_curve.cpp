#include "rubsweep/core/contact/stribeck_curve.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

constexpr int scan_points = 400;
constexpr int most_doublings = 60;

/// Largest coefficient for slip speeds from 0 to `highest`.
double peak(const model::StribeckFriction& friction, double highest) {
  const auto below = [&](double v) { return -friction_coefficient(friction, v); };
  int best = 0;
  for (int i = 1; i <= scan_points; ++i) {
    if (below(highest * i / scan_points) < below(highest * best / scan_points)) best = i;
  }
  const double left = highest * std::max(best - 1, 0) / scan_points;
  const double right = highest * std::min(best + 1, scan_points) / scan_points;
  return -boost::math::tools::brent_find_minima(below, left, right, 50).second;
}

}  // namespace

model::StribeckFriction stribeck_of(const model::StribeckCurve& curve) {
  if (!(curve.settle_speed_m_per_s > 1.5 * curve.peak_speed_m_per_s)) {
    throw ConfigError("settle_speed_m_per_s: allowed: more than 1.5 peak_speed_m_per_s");
  }
  if (!(curve.settle_speed_m_per_s <= largest_settle_over_peak * curve.peak_speed_m_per_s)) {
    throw ConfigError("settle_speed_m_per_s: allowed: at most 1e6 peak_speed_m_per_s");
  }
  model::StribeckFriction friction;
  friction.curve = curve;
  const double level = curve.kinetic - curve.viscous_s_per_m * curve.settle_speed_m_per_s;
  friction.gamma = {0,     2 / curve.peak_speed_m_per_s, 3 / curve.settle_speed_m_per_s,
                    level, 2 / curve.peak_speed_m_per_s, curve.viscous_s_per_m};
  const auto missing = [&](double gamma1) {
    friction.gamma[0] = gamma1;
    return peak(friction, curve.settle_speed_m_per_s) - curve.static_coefficient;
  };
  constexpr double rounding = 1e-12;
  if (missing(0) > rounding) throw ConfigError("static: allowed: no less than kinetic");
  if (missing(0) >= 0) return friction;
  double high = curve.static_coefficient;
  int doublings = 0;
  while (missing(high) < 0) {
    if (++doublings > most_doublings) throw ConfigError("static: allowed: a peak that such a curve can have");
    high *= 2;
  }
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      missing, 0.0, high, boost::math::tools::eps_tolerance<double>(50), iterations);
  friction.gamma[0] = (bracket.first + bracket.second) / 2;
  return friction;
}

}  // namespace rubsweep::contact
