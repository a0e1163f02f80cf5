#include "rubsweep/identify/campbell.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "rubsweep/identify/whirl_modes.hpp"
#include "rubsweep/numerics/assignment.hpp"

namespace rubsweep::identify {
namespace {

constexpr double sure = 0.9;      ///< an assurance that leaves no doubt which mode it is
constexpr double alike = 0.3;     ///< below it a mode is none of those before
constexpr int most_halvings = 8;  ///< of a step of the speed

/// A mode at one speed, as it is needed to follow it.
struct Followed {
  double speed_hz = 0;
  WhirlMode mode;
};
using Curve = std::vector<Followed>;

/// For each of `from` the one of `to` that continues it; empty where none does.
std::vector<std::optional<std::size_t>> continuation(const std::vector<const WhirlMode*>& from,
                                                     const std::vector<WhirlMode>& to, double& least) {
  const auto size = static_cast<Eigen::Index>(std::max(from.size(), to.size()));
  Eigen::MatrixXd cost = Eigen::MatrixXd::Ones(size, size);
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (std::size_t k = 0; k < to.size(); ++k)
      cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = 1 - assurance(*from[i], to[k]);
  }
  const auto taken = numerics::cheapest_assignment(cost);
  std::vector<std::optional<std::size_t>> found(from.size());
  least = 1;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double match = 1 - cost(static_cast<Eigen::Index>(i), taken[i]);
    least = std::min(least, match);
    if (match >= alike) found[i] = static_cast<std::size_t>(taken[i]);
  }
  return found;
}

/// Follows the modes of a rotor from its first speed on.
class Follower {
 public:
  Follower(const WhirlProblem& problem, double speed_hz) : problem_(problem) {
    for (WhirlMode& mode : problem.at(speed_hz)) {
      open_.push_back(curves_.size());
      curves_.push_back({{speed_hz, std::move(mode)}});
    }
  }

  void advance(double speed_hz, int halvings = 0) {
    std::vector<WhirlMode> modes = problem_.at(speed_hz);
    std::vector<const WhirlMode*> last;
    for (const std::size_t curve : open_) last.push_back(&curves_[curve].back().mode);
    double least = 1;
    const auto next = continuation(last, modes, least);
    const double before_hz = open_.empty() ? speed_hz : curves_[open_.front()].back().speed_hz;
    if (least < sure && halvings < most_halvings && before_hz < speed_hz) {
      advance(before_hz + (speed_hz - before_hz) / 2, halvings + 1);
      advance(speed_hz, halvings + 1);
      return;
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (!next[i]) continue;
      open.push_back(open_[i]);
      curves_[open_[i]].push_back({speed_hz, modes[*next[i]]});
    }
    open_ = std::move(open);
  }

  const std::vector<Curve>& curves() const { return curves_; }

 private:
  const WhirlProblem& problem_;
  std::vector<Curve> curves_;
  std::vector<std::size_t> open_;  ///< curves that have not ended
};

/// The mode at a speed that is most like `reference`.
WhirlMode alike_at(const WhirlProblem& problem, double speed_hz, const WhirlMode& reference) {
  std::vector<WhirlMode> modes = problem.at(speed_hz);
  return *std::ranges::max_element(modes, {},
                                   [&](const WhirlMode& mode) { return assurance(mode, reference); });
}

/// Whirl frequency beyond the shaft speed.
double excess_hz(const Followed& point) { return point.mode.frequency_hz() - point.speed_hz; }

Followed locate(const WhirlProblem& problem, const Followed& low, const Followed& high) {
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

std::vector<Followed> critical_points(const WhirlProblem& problem, const Curve& curve) {
  std::vector<Followed> found;
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

ModeShape shape_of(const FreeRotor& rotor, const Followed& at, int number) {
  ModeShape shape{number,
                  at.speed_hz,
                  at.mode.frequency_hz(),
                  at.mode.forward_share,
                  rotor.x * at.mode.shape,
                  rotor.y * at.mode.shape};
  Eigen::Index place_x = 0, place_y = 0;
  const double largest_x = shape.x.cwiseAbs().maxCoeff(&place_x),
               largest_y = shape.y.cwiseAbs().maxCoeff(&place_y);
  // On a circular orbit the two are equal but for rounding: x then leads.
  const std::complex<double> largest =
      largest_x >= (1 - 1e-6) * largest_y ? shape.x(place_x) : shape.y(place_y);
  if (largest != 0.0) {
    shape.x /= largest;
    shape.y /= largest;
  }
  return shape;
}

bool comes_below(const Curve& curve, double up_to_hz) {
  return std::ranges::any_of(curve,
                             [&](const Followed& point) { return point.mode.frequency_hz() <= up_to_hz; });
}

CampbellMode asked_points(const Curve& curve, int number, std::span<const double> speeds_hz) {
  CampbellMode mode{number, {}};
  std::size_t k = 0;
  for (const double speed_hz : speeds_hz) {
    while (k < curve.size() && curve[k].speed_hz < speed_hz) ++k;
    if (k == curve.size()) break;
    const WhirlMode& whirl = curve[k].mode;
    mode.points.push_back({speed_hz, whirl.frequency_hz(), whirl.damping_ratio(), whirl.forward_share});
  }
  return mode;
}

}  // namespace

Campbell campbell(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz) {
  const WhirlProblem problem(rotor);
  Follower follower(problem, speeds_hz.front());
  for (const double speed_hz : speeds_hz.subspan(1)) follower.advance(speed_hz);
  Campbell diagram{rotor.position_m, {}, {}, {}};
  int number = 0;
  for (const Curve& curve : follower.curves()) {
    ++number;
    if (number > 2 && !comes_below(curve, up_to_hz)) continue;
    diagram.modes.push_back(asked_points(curve, number, speeds_hz));
    const std::vector<Followed> critical = critical_points(problem, curve);
    for (const auto& [speed_hz, mode] : critical)
      diagram.critical_speeds.push_back({number, speed_hz, mode.damping_ratio(), mode.forward_share});
    diagram.shapes.push_back(shape_of(rotor, critical.empty() ? curve.front() : critical.front(), number));
  }
  std::ranges::stable_sort(diagram.critical_speeds, {}, &CriticalSpeed::speed_hz);
  return diagram;
}

}  // namespace rubsweep::identify
