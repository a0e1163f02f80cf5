#include "rubsweep/measurement/fit/ramp.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace rubsweep::fit {
namespace {

using std::numbers::pi;

/// Piece of a ramp with knots that holds an instant, or is the nearest one.
std::size_t piece_of(const Ramp& ramp, double t_s) {
  const auto above = std::ranges::upper_bound(ramp.knot_s, t_s) - ramp.knot_s.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(ramp.knot_s) - 2));
}

double rate_hz_per_s(const Ramp& ramp, std::size_t piece) {
  return (ramp.knot_hz[piece + 1] - ramp.knot_hz[piece]) / (ramp.knot_s[piece + 1] - ramp.knot_s[piece]);
}

}  // namespace

double speed_hz(const Ramp& ramp, double t_s) {
  if (ramp.even()) return ramp.from_hz + ramp.rate_hz_per_s * t_s;
  const std::size_t piece = piece_of(ramp, t_s);
  return ramp.knot_hz[piece] + rate_hz_per_s(ramp, piece) * (t_s - ramp.knot_s[piece]);
}

RampTurning::RampTurning(const Ramp& ramp) : ramp_(ramp) {
  if (ramp.even()) {
    most_gain_ = std::abs(2 * pi * ramp.rate_hz_per_s);
    return;
  }
  turns_.push_back(0);
  for (std::size_t k = 0; k + 1 < ramp.knot_s.size(); ++k) {
    turns_.push_back(turns_.back() +
                     (ramp.knot_hz[k] + ramp.knot_hz[k + 1]) / 2 * (ramp.knot_s[k + 1] - ramp.knot_s[k]));
    most_gain_ = std::max(most_gain_, std::abs(2 * pi * rate_hz_per_s(ramp, k)));
  }
}

double RampTurning::speed(double t_s) const { return 2 * pi * speed_hz(ramp_, t_s); }

double RampTurning::gain(double t_s) const {
  return 2 * pi * (ramp_.even() ? ramp_.rate_hz_per_s : rate_hz_per_s(ramp_, piece_of(ramp_, t_s)));
}

double RampTurning::angle(double t_s) const {
  if (ramp_.even()) return 2 * pi * (ramp_.from_hz * t_s + ramp_.rate_hz_per_s * t_s * t_s / 2);
  const std::size_t piece = piece_of(ramp_, t_s);
  const double since = t_s - ramp_.knot_s[piece];
  return 2 * pi *
         (turns_[piece] + ramp_.knot_hz[piece] * since + rate_hz_per_s(ramp_, piece) * since * since / 2);
}

std::pair<double, double> RampTurning::speeds_between(double from_s, double to_s) const {
  auto [low, high] = std::minmax({speed(from_s), speed(to_s)});
  for (std::size_t k = 0; k < ramp_.knot_s.size(); ++k) {
    if (ramp_.knot_s[k] <= from_s || ramp_.knot_s[k] >= to_s) continue;
    low = std::min(low, 2 * pi * ramp_.knot_hz[k]);
    high = std::max(high, 2 * pi * ramp_.knot_hz[k]);
  }
  return {low, high};
}

}  // namespace rubsweep::fit
