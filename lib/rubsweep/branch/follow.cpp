#include "rubsweep/branch/follow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "rubsweep/branch/growing_half.hpp"
#include "rubsweep/branch/locate.hpp"
#include "rubsweep/branch/margins.hpp"
#include "rubsweep/branch/multiplier_slopes.hpp"
#include "rubsweep/branch/orbit_newton.hpp"
#include "rubsweep/branch/segment.hpp"

namespace rubsweep::branch {
namespace {

constexpr int easy_iterations = 4;

bool in_range(const OrbitProblem& problem, double parameter) {
  return parameter >= problem.low && parameter <= problem.high;
}

/// Whether its turns begin in the same states before the period is over. Close to where a branch joins that
/// of a shorter period Newton's iteration leaves as much as this.
bool repeats_sooner(const BranchPoint& point) {
  constexpr double same = 1e-6;
  const auto& sections = point.facts.sections;
  for (std::size_t k = 1; k < sections.size(); ++k) {
    if (sections.size() % k == 0 && (sections[k] - point.state).cwiseAbs().maxCoeff() < same) return true;
  }
  return false;
}

class Follower {
 public:
  Follower(const OrbitProblem& problem, const BranchPoint& start, const FollowOptions& options)
      : problem_(problem), options_(options), side_(start, options) {
    start_turns_ = problem.facts ? start.facts.sections : std::vector<Eigen::VectorXd>{start.state};
  }

  HalfBranch run() {
    side_.grow([&] { make_step(); });
    return std::move(side_.half);
  }

 private:
  const BranchPoint& here() const { return side_.here(); }

  void make_step() {
    const Position guess = position_of(problem_, here()) + side_.step() * here().tangent;
    const Correction found = correct(problem_, guess, here().tangent, here().difference_step);
    if (found.evaluation == Evaluation::infeasible) return side_.shorten(Ending::infeasible);
    if (found.evaluation == Evaluation::failed) return side_.shorten(Ending::failed);
    if (!found.converged || side_.is_far((position_of(problem_, found.point) - guess).norm()))
      return side_.shorten(Ending::step_too_small);
    if (!in_range(problem_, found.point.parameter)) return step_to_end_of_range(found.point);
    auto next = completed(problem_, found.point, here().tangent, here().arclength + side_.step());
    if (!next) return side_.shorten(Ending::singular);
    const double turn = next->tangent.dot(here().tangent);
    if (side_.turns_sharply(turn) || falls_on_shorter_period(*next) || !accept(std::move(*next)))
      return side_.shorten(Ending::step_too_small);
    side_.lengthen(turn, found.iterations <= easy_iterations);
  }

  void step_to_end_of_range(const BranchPoint& beyond) {
    const double parameter = std::clamp(beyond.parameter, problem_.low, problem_.high);
    if (here().parameter == parameter) return side_.end(Ending::left_range);
    const double share = (parameter - here().parameter) / (beyond.parameter - here().parameter);
    Correction found = correct_at(problem_, here().state + share * (beyond.state - here().state), parameter);
    if (!found.converged) return side_.shorten(Ending::step_too_small);
    found.point.parameter = parameter;  // not as its coordinate rounds it
    const double length =
        here().tangent.dot(position_of(problem_, found.point) - position_of(problem_, here()));
    auto last = completed(problem_, found.point, here().tangent, here().arclength + length);
    if (!last || !(length > 0) || length > 2 * side_.step()) return side_.shorten(Ending::step_too_small);
    if (falls_on_shorter_period(*last) || !accept(std::move(*last)))
      return side_.shorten(Ending::step_too_small);
    if (!side_.ended()) side_.end(Ending::left_range);
  }

  /// Every orbit is also one of twice its period: a step from an orbit onto one whose turns repeat sooner has
  /// left the branch.
  bool falls_on_shorter_period(const BranchPoint& next) const {
    return repeats_sooner(next) && !repeats_sooner(here());
  }

  /// False where what lies between here and `next` is not one piece of a branch.
  bool accept(BranchPoint next) {
    if (is_closed_by(next)) return true;
    next.slopes = multiplier_slopes(problem_, next);
    if (options_.every_graze) next.margins = margins_of(problem_, next);
    auto events = events_between(problem_, here(), next, options_.every_graze);
    if (!events) return false;
    for (BranchEvent& event : *events) {
      side_.half.events.push_back(std::move(event));
      if (ends_at(side_.half.events.back())) return true;
    }
    side_.half.points.push_back(std::move(next));
    return true;
  }

  /// The event's own orbit is then the last one of the branch.
  bool ends_at(const BranchEvent& event) {
    const bool off = options_.stop_off_the_walls && event.kind == EventKind::graze &&
                     side_.half.points.front().facts.touched && !event.point.facts.touched;
    const bool changes = event.kind != EventKind::graze && event.kind != EventKind::sequence;
    if (event.kind == EventKind::period_halving) {
      side_.end(Ending::period_halving);
    } else if (off) {
      side_.end(Ending::off_the_walls);
    } else if (options_.stop_at_first_change && changes) {
      side_.end(Ending::first_change);
    } else {
      return false;
    }
    side_.half.points.push_back(event.point);
    return true;
  }

  /// Whether the start lies between here and `next`, up to a shift by whole turns: the branch then ends
  /// there.
  bool is_closed_by(const BranchPoint& next) {
    if (side_.half.points.size() < 3) return false;
    constexpr double same = 1e-7;
    const BranchPoint& start = side_.half.points.front();
    const Position a = position_of(problem_, here());
    for (const Eigen::VectorXd& state : start_turns_) {
      const Position b = position_of(problem_, state, start.parameter);
      const double ahead = here().tangent.dot(b - a), step = next.arclength - here().arclength;
      if (ahead <= 0 || ahead > step || (b - a).norm() > 1.5 * step) continue;
      const Correction found = correct(problem_, b, here().tangent);
      if (!found.converged || (position_of(problem_, found.point) - b).norm() > same) continue;
      // The plane through the start meets the branch there only if this piece of it leads to the start.
      const Segment segment(problem_, here(), next);
      const auto there = segment.at(ahead);
      if (!there || (position_of(problem_, *there) - b).norm() > same) continue;
      auto events = events_between(problem_, here(), *there, options_.every_graze);
      if (!events) continue;
      std::ranges::move(*events, std::back_inserter(side_.half.events));
      side_.half.points.push_back(*there);
      side_.end(Ending::closed);
      return true;
    }
    return false;
  }

  const OrbitProblem& problem_;
  const FollowOptions& options_;
  GrowingHalf<HalfBranch> side_;
  std::vector<Eigen::VectorXd> start_turns_;
};

}  // namespace

std::optional<BranchPoint> orbit_from(const OrbitProblem& problem, const Eigen::VectorXd& state,
                                      double parameter) {
  const Correction found = correct_at(problem, state, parameter);
  if (!found.converged) return std::nullopt;
  Eigen::VectorXd along_parameter = Eigen::VectorXd::Zero(state.size() + 1);
  along_parameter(state.size()) = 1;
  return completed(problem, found.point, along_parameter, 0);
}

BranchPoint turned_about(BranchPoint point) {
  point.tangent = -point.tangent;
  point.branching = -point.branching;  // its last row is the tangent
  if (point.slopes) point.slopes = {-point.slopes->unit, -point.slopes->doubling, -point.slopes->torus};
  return point;
}

HalfBranch follow(const OrbitProblem& problem, const BranchPoint& start, const FollowOptions& options) {
  return Follower(problem, start, options).run();
}

Branch follow_both_ways(const OrbitProblem& problem, const BranchPoint& start, const FollowOptions& options) {
  HalfBranch rising = follow(problem, start, options), falling{{}, {}, rising.ending};
  if (rising.ending != Ending::closed) {
    falling = follow(problem, turned_about(start), options);
    falling.points.erase(falling.points.begin());  // the start, which is the first of the other side
    turn_about(falling.points, [](BranchPoint& point) -> BranchPoint& { return point; });
    turn_about(falling.events, [](BranchEvent& event) -> BranchPoint& { return event.point; });
  }
  return {problem.order, joined(std::move(falling.points), std::move(rising.points)),
          joined(std::move(falling.events), std::move(rising.events)), falling.ending, rising.ending};
}

}  // namespace rubsweep::branch
