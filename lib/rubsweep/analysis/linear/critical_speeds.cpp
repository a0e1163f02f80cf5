#include "rubsweep/analysis/linear/critical_speeds.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <optional>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::linear {
namespace {

/// The mode at a speed that is most like one of a speed nearby.
WhirlMode alike_at(const WhirlProblem& problem, double speed_hz, const WhirlMode& reference) {
  if (auto continued = problem.continued(reference, speed_hz)) return std::move(*continued);
  const std::vector<WhirlMode> modes = problem.at(speed_hz).modes;
  if (modes.empty()) throw SolverError("Campbell diagram: a mode is lost between two speeds");
  return *std::ranges::max_element(modes, {},
                                   [&](const WhirlMode& mode) { return assurance(mode, reference); });
}

/// Whirl frequency beyond the shaft speed.
double excess_hz(const FollowedMode& point) { return point.mode.frequency_hz() - point.speed_hz; }

FollowedMode locate(const WhirlProblem& problem, const FollowedMode& low, const FollowedMode& high) {
  const auto excess = [&](double speed_hz) {
    return alike_at(problem, speed_hz, low.mode).frequency_hz() - speed_hz;
  };
  std::uintmax_t iterations = 400;  // four halve the bracket at least: it ends before
  const auto bracket =
      boost::math::tools::toms748_solve(excess, low.speed_hz, high.speed_hz, excess_hz(low), excess_hz(high),
                                        boost::math::tools::eps_tolerance<double>(48), iterations);
  const double speed_hz = bracket.first + (bracket.second - bracket.first) / 2;
  return {speed_hz, alike_at(problem, speed_hz, low.mode)};
}

}  // namespace

std::vector<FollowedMode> critical_points(const WhirlProblem& problem, std::span<const FollowedMode> curve) {
  std::vector<FollowedMode> found;
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const double low = excess_hz(curve[k - 1]), high = excess_hz(curve[k]);
    if (high == 0) {
      found.push_back(curve[k]);
    } else if (low * high < 0) {
      found.push_back(locate(problem, curve[k - 1], curve[k]));
    }
  }
  return found;
}

}  // namespace rubsweep::linear
