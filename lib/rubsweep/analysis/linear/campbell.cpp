#include "rubsweep/analysis/linear/campbell.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cstdint>
#include <optional>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/assignment.hpp"

namespace rubsweep::linear {
namespace {

constexpr double sure = 0.9;      ///< smallest assurance criterion at which two modes are surely the same
constexpr double alike = 0.3;     ///< smallest assurance criterion of a mode that continues an earlier mode
constexpr int most_halvings = 8;  ///< limit on halvings of a step of the speed

using Curve = std::vector<FollowedMode>;

/// Continuation of curves from one speed to the next: for each mode of `from` its index in `to` (empty if it
/// has no continuation), and the new modes of `to`.
struct Continuation {
  std::vector<std::optional<std::size_t>> next;
  std::vector<std::size_t> fresh;
  bool doubtful = false;  ///< true: at least one mode up to the frequency `up_to_hz` is doubtful
};

Continuation continuation(const std::vector<const WhirlMode*>& from, const std::vector<WhirlMode>& to,
                          double up_to_hz) {
  const auto size = static_cast<Eigen::Index>(std::max(from.size(), to.size()));
  Eigen::MatrixXd cost = Eigen::MatrixXd::Ones(size, size);
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = 0; k < to.size(); ++k)
      cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = 1 - assurance(*from[i], to[k]);
  }
  const auto taken = numerics::cheapest_assignment(cost);
  Continuation found;
  found.next.resize(from.size());
  std::vector<bool> known(to.size(), false);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double match = 1 - cost(static_cast<Eigen::Index>(i), taken[i]);
    found.doubtful = found.doubtful || (match < sure && from[i]->frequency_hz() <= up_to_hz);
    if (match < alike) continue;
    found.next[i] = static_cast<std::size_t>(taken[i]);
    known[*found.next[i]] = true;
  }
  for (std::size_t k = 0; k < to.size(); ++k) {
    if (known[k]) continue;
    found.fresh.push_back(k);
    found.doubtful = found.doubtful || to[k].frequency_hz() <= up_to_hz;
  }
  return found;
}

/// Follows the modes of a rotor from its first speed on. Curves end where a mode becomes overdamped, and new
/// ones begin where a mode starts to oscillate.
class Follower {
 public:
  Follower(const WhirlProblem& problem, double speed_hz, double up_to_hz)
      : problem_(problem), last_hz_(speed_hz), up_to_hz_(up_to_hz) {
    WhirlModes found = problem.at(speed_hz);
    growth_per_s_ = found.growth_per_s;
    for (WhirlMode& mode : found.modes) begin(speed_hz, std::move(mode));
  }

  void advance(double speed_hz, int halvings = 0) {
    WhirlModes found = problem_.at(speed_hz);
    std::vector<const WhirlMode*> last;
    for (const std::size_t curve : open_) last.push_back(&curves_[curve].back().mode);
    const Continuation to = continuation(last, found.modes, up_to_hz_);
    if (to.doubtful && halvings < most_halvings && last_hz_ < speed_hz) {
      advance(last_hz_ + (speed_hz - last_hz_) / 2, halvings + 1);
      advance(speed_hz, halvings + 1);
      return;
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (!to.next[i]) continue;
      open.push_back(open_[i]);
      curves_[open_[i]].push_back({speed_hz, std::move(found.modes[*to.next[i]])});
    }
    open_ = std::move(open);
    for (const std::size_t k : to.fresh) begin(speed_hz, std::move(found.modes[k]));
    last_hz_ = speed_hz;
    growth_per_s_ = found.growth_per_s;
  }

  const std::vector<Curve>& curves() const { return curves_; }
  double growth_per_s() const { return growth_per_s_; }  ///< at the last speed

 private:
  void begin(double speed_hz, WhirlMode mode) {
    open_.push_back(curves_.size());
    curves_.push_back({{speed_hz, std::move(mode)}});
  }

  const WhirlProblem& problem_;
  double last_hz_, up_to_hz_, growth_per_s_ = 0;
  std::vector<Curve> curves_;
  std::vector<std::size_t> open_;  ///< curves that have not ended yet
};

ModeShape shape_of(const FreeRotor& rotor, const FollowedMode& at, int number) {
  ModeShape shape{number,
                  at.speed_hz,
                  at.mode.frequency_hz(),
                  at.mode.forward_share,
                  rotor.x * at.mode.shape,
                  rotor.y * at.mode.shape};
  Eigen::Index place_x = 0, place_y = 0;
  const double largest_x = shape.x.cwiseAbs().maxCoeff(&place_x),
               largest_y = shape.y.cwiseAbs().maxCoeff(&place_y);
  // On a circular orbit the largest x and the largest y are equal up to rounding; x is then used.
  const std::complex<double> largest =
      largest_x >= (1 - 1e-6) * largest_y ? shape.x(place_x) : shape.y(place_y);
  if (largest != 0.0) {
    shape.x /= largest;
    shape.y /= largest;
  }
  return shape;
}

/// Whether a curve falls below the frequency `up_to_hz`, or its mode grows at some speed.
bool is_shown(const Curve& curve, double up_to_hz) {
  return std::ranges::any_of(curve, [&](const FollowedMode& point) {
    return point.mode.frequency_hz() <= up_to_hz || point.mode.root_per_s.real() > 0;
  });
}

CampbellMode asked_points(const Curve& curve, int number, std::span<const double> speeds_hz) {
  CampbellMode mode{number, {}};
  std::size_t k = 0;
  for (const double speed_hz : speeds_hz) {
    while (k < curve.size() && curve[k].speed_hz < speed_hz) ++k;
    if (k == curve.size()) break;
    if (curve[k].speed_hz > speed_hz) continue;
    const WhirlMode& whirl = curve[k].mode;
    mode.points.push_back({speed_hz, whirl.frequency_hz(), whirl.damping_ratio(), whirl.forward_share});
  }
  return mode;
}

/// Mode at `speed_hz` that is most similar to `reference`, a mode at a speed nearby.
WhirlMode alike_at(const WhirlProblem& problem, double speed_hz, const WhirlMode& reference) {
  if (auto continued = problem.continued(reference, speed_hz)) return std::move(*continued);
  const std::vector<WhirlMode> modes = problem.at(speed_hz).modes;
  if (modes.empty()) throw SolverError("Campbell diagram: a mode is lost between two speeds");
  return *std::ranges::max_element(modes, {},
                                   [&](const WhirlMode& mode) { return assurance(mode, reference); });
}

/// Whirl frequency minus shaft speed, zero at a critical speed.
double excess_hz(const FollowedMode& point) { return point.mode.frequency_hz() - point.speed_hz; }

FollowedMode locate(const WhirlProblem& problem, const FollowedMode& low, const FollowedMode& high) {
  const auto excess = [&](double speed_hz) {
    return alike_at(problem, speed_hz, low.mode).frequency_hz() - speed_hz;
  };
  std::uintmax_t iterations = 400;  // never reached, since four evaluations at least halve the bracket
  const auto bracket =
      boost::math::tools::toms748_solve(excess, low.speed_hz, high.speed_hz, excess_hz(low), excess_hz(high),
                                        boost::math::tools::eps_tolerance<double>(48), iterations);
  const double speed_hz = bracket.first + (bracket.second - bracket.first) / 2;
  return {speed_hz, alike_at(problem, speed_hz, low.mode)};
}

}  // namespace

Campbell campbell(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz) {
  const WhirlProblem problem(rotor, speeds_hz, up_to_hz);
  Campbell diagram{rotor.position_m, {}, {}, {}, {}};
  Follower follower(problem, speeds_hz.front(), up_to_hz);
  diagram.growth.push_back({speeds_hz.front(), follower.growth_per_s()});
  for (const double speed_hz : speeds_hz.subspan(1)) {
    follower.advance(speed_hz);
    diagram.growth.push_back({speed_hz, follower.growth_per_s()});
  }
  int number = 0;
  for (const Curve& curve : follower.curves()) {
    ++number;
    if (number > 2 && !is_shown(curve, up_to_hz)) continue;
    diagram.modes.push_back(asked_points(curve, number, speeds_hz));
    const std::vector<FollowedMode> critical = critical_points(problem, curve);
    for (const auto& [speed_hz, mode] : critical)
      diagram.critical_speeds.push_back({number, speed_hz, mode.damping_ratio(), mode.forward_share});
    diagram.shapes.push_back(shape_of(rotor, critical.empty() ? curve.front() : critical.front(), number));
  }
  std::ranges::stable_sort(diagram.critical_speeds, {}, &CriticalSpeed::speed_hz);
  return diagram;
}

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
