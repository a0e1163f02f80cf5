#include "rubsweep/analysis/branch/continuation/graze.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/continuation/segment.hpp"
#include "rubsweep/analysis/branch/orbits/contact_sequence.hpp"

namespace rubsweep::branch::continuation {
namespace {

constexpr double width_wanted = 1e-12;  ///< length along the branch
constexpr int most_looks = 200;
constexpr std::size_t most_grazes = 16;  ///< limit between two points
/// Longest stretch, in rotation, that counts as close to its graze.
constexpr double short_stretch_rad = 0.3;

using OrbitSegment = Segment<orbits::OrbitProblem, BranchPoint>;

/// Orbit at the distance s along a segment.
struct Side {
  double s = 0;
  BranchPoint point;
};

class GrazeSearch {
 public:
  GrazeSearch(const OrbitSegment& segment, const BranchPoint& from, const BranchPoint& to, int order)
      : segment_(segment),
        period_rad_(2 * std::numbers::pi * order),
        low_{0, from},
        high_{segment.length(), to} {}

  BranchEvent find(const orbits::OrbitProblem& problem) {
    for (int look = 0; look < most_looks && width() > width_wanted; ++look) {
      const auto change = change_now();
      const double s = change ? next_by_root(*change) : (low_.s + high_.s) / 2;
      if (!look_at(s)) break;
    }
    return result(problem);
  }

  bool enclosed(const orbits::OrbitProblem& problem) const {
    return continuous(problem, low_.point, high_.point);
  }

 private:
  double width() const { return high_.s - low_.s; }
  bool high_is_richer() const {
    return orbits::is_richer(high_.point.facts.switches, low_.point.facts.switches);
  }
  const Side& richer() const { return high_is_richer() ? high_ : low_; }
  const Side& poorer() const { return high_is_richer() ? low_ : high_; }

  std::optional<orbits::SequenceChange> change_now() const {
    const auto change =
        orbits::sequence_change(richer().point.facts.switches, poorer().point.facts.switches, period_rad_);
    return change && change->duration_rad < short_stretch_rad ? change : std::nullopt;
  }

  /// Next distance s to evaluate. The root of the squared duration is extrapolated linearly from the last two
  /// orbits on the richer side. The first target lies slightly before the root, so that the end of the
  /// interval on the richer side comes close. The next target lies just beyond the root, for the other end.
  double next_by_root(const orbits::SequenceChange& change) {
    const double middle = (low_.s + high_.s) / 2, s = richer().s;
    const double value = change.duration_rad * change.duration_rad;
    if (s != last_s_ && last_s_ >= 0) {
      const double slope = (value - last_value_) / (s - last_s_);
      if (slope != 0 && std::isfinite(slope)) root_ = s - value / slope;
    }
    if (s != last_s_) {
      last_s_ = s;
      last_value_ = value;
      aims_ = 0;
    }
    if (!(root_ > low_.s && root_ < high_.s) || aims_ > 3) return middle;
    // Targets at 1/100, then 1/20 of the distance between the root and the last orbit of the richer side:
    // first on the richer side of the root, then on the other.
    const double away = std::max(std::abs(s - root_) * 0.01 * std::pow(5, aims_ / 2), width_wanted / 4);
    const double aim = root_ + (aims_ % 2 == 0 ? 1 : -1) * (s > root_ ? away : -away);
    ++aims_;
    return aim > low_.s && aim < high_.s ? aim : middle;
  }

  bool look_at(double s) {
    if (!(s > low_.s && s < high_.s)) return false;
    auto point = segment_.at(s);
    if (!point) return false;
    Side& side = orbits::same_contact(point->facts, low_.point.facts) ? low_ : high_;
    side = {s, std::move(*point)};
    return true;
  }

  BranchEvent result(const orbits::OrbitProblem& problem) const {
    const auto change =
        orbits::sequence_change(richer().point.facts.switches, poorer().point.facts.switches, period_rad_);
    BranchEvent event{
        change ? EventKind::graze : EventKind::sequence,
        high_.point,
        std::abs(high_.point.parameter - low_.point.parameter) / 2 +
            std::max(rounding_of_parameter(problem, low_.point), rounding_of_parameter(problem, high_.point)),
        {}};
    if (change) {
      event.detail =
          fmt::format("{} {}", orbits::describe(*change), high_is_richer() ? "appears" : "disappears");
      event.change = change;
    }
    return event;
  }

  const OrbitSegment& segment_;
  double period_rad_;
  Side low_, high_;
  double root_ = -1, last_s_ = -1, last_value_ = 0;
  int aims_ = 0;
};

}  // namespace

std::optional<std::vector<BranchEvent>> grazes_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to) {
  std::vector<BranchEvent> events;
  BranchPoint here = from;
  while (events.size() < most_grazes && !orbits::same_contact(here.facts, to.facts)) {
    const Segment segment(problem, here, to);
    if (!(segment.length() > width_wanted)) break;
    GrazeSearch search(segment, here, to, problem.order);
    events.push_back(search.find(problem));
    if (!search.enclosed(problem)) return std::nullopt;
    if (!(events.back().point.arclength > here.arclength)) break;
    here = events.back().point;  // just behind the event
  }
  return events;
}

}  // namespace rubsweep::branch::continuation
