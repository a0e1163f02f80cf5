#include "rubsweep/branch/follow.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "rubsweep/branch/locate.hpp"
#include "rubsweep/branch/orbit_newton.hpp"
#include "rubsweep/branch/segment.hpp"

namespace rubsweep::branch {
namespace {

constexpr double gentle_turn = 0.985;  ///< cosine of the angle between tangents that lets the step grow
constexpr double sharp_turn = 0.94;    ///< and of the one that halves it
constexpr double most_missed = 0.2;    ///< by the guess, per step
constexpr int easy_iterations = 4;

bool in_range(const OrbitProblem& problem, double parameter) {
  return parameter >= problem.low && parameter <= problem.high;
}

/// Whether its turns begin in the same states before the period is over.
bool repeats_sooner(const BranchPoint& point) {
  constexpr double same = 1e-8;
  const auto& sections = point.facts.sections;
  for (std::size_t k = 1; k < sections.size(); ++k) {
    if (sections.size() % k == 0 && (sections[k] - point.state).cwiseAbs().maxCoeff() < same) return true;
  }
  return false;
}

class Follower {
 public:
  Follower(const OrbitProblem& problem, const BranchPoint& start, const FollowOptions& options)
      : problem_(problem), options_(options), step_(options.first_step) {
    half_.points.push_back(start);
    start_turns_ = problem.facts ? start.facts.sections : std::vector<Eigen::VectorXd>{start.state};
  }

  HalfBranch run() {
    while (!ended_) {
      if (half_.points.size() >= static_cast<std::size_t>(options_.most_points)) {
        end(Ending::point_limit);
      } else {
        make_step();
      }
    }
    return std::move(half_);
  }

 private:
  const BranchPoint& here() const { return half_.points.back(); }

  void end(Ending ending) {
    half_.ending = ending;
    ended_ = true;
  }

  /// No orbit was found one step ahead: half of it, until there is no half.
  void shorten(Ending otherwise) {
    step_ /= 2;
    if (step_ < options_.shortest_step) end(otherwise);
  }

  void make_step() {
    const Position guess = position_of(problem_, here()) + step_ * here().tangent;
    const Correction found = correct(problem_, guess, here().tangent);
    if (found.evaluation == Evaluation::infeasible) return shorten(Ending::infeasible);
    if (found.evaluation == Evaluation::failed) return shorten(Ending::failed);
    if (!found.converged) return shorten(Ending::step_too_small);
    // Farther from the guess it may be another branch, or another part of this one.
    if ((position_of(problem_, found.point) - guess).norm() > most_missed * step_)
      return shorten(Ending::step_too_small);
    if (!in_range(problem_, found.point.parameter)) return step_to_end_of_range(found.point);
    auto next = completed(problem_, found.point, here().tangent, here().arclength + step_);
    if (!next) return shorten(Ending::singular);
    const double turn = next->tangent.dot(here().tangent);
    if (turn < sharp_turn && step_ > 100 * options_.shortest_step) return shorten(Ending::step_too_small);
    if (falls_on_shorter_period(*next) || !accept(std::move(*next))) return shorten(Ending::step_too_small);
    if (turn > gentle_turn && found.iterations <= easy_iterations)
      step_ = std::min(options_.longest_step, 1.5 * step_);
  }

  void step_to_end_of_range(const BranchPoint& beyond) {
    const double parameter = std::clamp(beyond.parameter, problem_.low, problem_.high);
    if (here().parameter == parameter) return end(Ending::left_range);
    const double share = (parameter - here().parameter) / (beyond.parameter - here().parameter);
    Correction found = correct_at(problem_, here().state + share * (beyond.state - here().state), parameter);
    if (!found.converged) return shorten(Ending::step_too_small);
    found.point.parameter = parameter;  // not as its coordinate rounds it
    const double length =
        here().tangent.dot(position_of(problem_, found.point) - position_of(problem_, here()));
    auto last = completed(problem_, found.point, here().tangent, here().arclength + length);
    if (!last || !(length > 0) || length > 2 * step_) return shorten(Ending::step_too_small);
    if (!accept(std::move(*last))) return shorten(Ending::step_too_small);
    if (!ended_) end(Ending::left_range);
  }

  /// Every orbit is also one of twice its period: a step from an orbit onto one whose turns repeat sooner has
  /// left the branch.
  bool falls_on_shorter_period(const BranchPoint& next) const {
    return repeats_sooner(next) && !repeats_sooner(here());
  }

  /// False where what lies between here and `next` is not one piece of a branch.
  bool accept(BranchPoint next) {
    if (is_closed_by(next)) return true;
    auto events = events_between(problem_, here(), next, options_.every_graze);
    if (!events) return false;
    for (BranchEvent& event : *events) {
      half_.events.push_back(std::move(event));
      if (ends_at(half_.events.back())) return true;
    }
    half_.points.push_back(std::move(next));
    return true;
  }

  /// The event's own orbit is then the last one of the branch.
  bool ends_at(const BranchEvent& event) {
    const bool off = options_.stop_off_the_walls && event.kind == EventKind::graze &&
                     half_.points.front().facts.touched && !event.point.facts.touched;
    const bool changes = event.kind != EventKind::graze && event.kind != EventKind::sequence;
    if (event.kind == EventKind::period_halving) {
      end(Ending::period_halving);
    } else if (off) {
      end(Ending::off_the_walls);
    } else if (options_.stop_at_first_change && changes) {
      end(Ending::first_change);
    } else {
      return false;
    }
    half_.points.push_back(event.point);
    return true;
  }

  /// Whether the start lies between here and `next`, up to a shift by whole turns: the branch then ends
  /// there.
  bool is_closed_by(const BranchPoint& next) {
    if (half_.points.size() < 3) return false;
    constexpr double same = 1e-7;
    const BranchPoint& start = half_.points.front();
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
      std::ranges::move(*events, std::back_inserter(half_.events));
      half_.points.push_back(*there);
      end(Ending::closed);
      return true;
    }
    return false;
  }

  const OrbitProblem& problem_;
  const FollowOptions& options_;
  double step_;
  std::vector<Eigen::VectorXd> start_turns_;
  HalfBranch half_;
  bool ended_ = false;
};

/// Its arclengths as those of the other side: below 0.
void turn_half_about(HalfBranch& half) {
  for (BranchPoint& point : half.points) point.arclength = -point.arclength;
  for (BranchEvent& event : half.events) event.point.arclength = -event.point.arclength;
  std::ranges::reverse(half.points);
  std::ranges::reverse(half.events);
}

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
  return point;
}

HalfBranch follow(const OrbitProblem& problem, const BranchPoint& start, const FollowOptions& options) {
  return Follower(problem, start, options).run();
}

Branch follow_both_ways(const OrbitProblem& problem, const BranchPoint& start, const FollowOptions& options) {
  Branch branch;
  branch.order = problem.order;
  HalfBranch rising = follow(problem, start, options);
  branch.rising = branch.falling = rising.ending;
  if (rising.ending != Ending::closed) {
    HalfBranch falling = follow(problem, turned_about(start), options);
    branch.falling = falling.ending;
    turn_half_about(falling);
    falling.points.pop_back();  // the start, which is the first of the other side
    branch.points = std::move(falling.points);
    branch.events = std::move(falling.events);
  }
  std::ranges::move(rising.points, std::back_inserter(branch.points));
  std::ranges::move(rising.events, std::back_inserter(branch.events));
  return branch;
}

}  // namespace rubsweep::branch
