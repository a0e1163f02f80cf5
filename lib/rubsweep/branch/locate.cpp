#include "rubsweep/branch/locate.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include "rubsweep/branch/graze.hpp"
#include "rubsweep/branch/multipliers.hpp"
#include "rubsweep/branch/segment.hpp"

namespace rubsweep::branch {
namespace {

/// Roots are enclosed to this, in the coordinate along the branch.
constexpr double root_width = 1e-12;
constexpr std::uintmax_t root_evaluations = 100;

using Test = double (*)(const BranchPoint&);

double fold_test(const BranchPoint& point) { return point.tangent(point.tangent.size() - 1); }
double branching_test(const BranchPoint& point) { return point.branching; }
double doubling_test_of(const BranchPoint& point) { return doubling_test(point.multipliers); }
double torus_test_of(const BranchPoint& point) { return torus_test(point.multipliers); }

struct NoOrbit {};

BranchPoint orbit_at(const Segment& segment, double s) {
  auto point = segment.at(s);
  if (!point) throw NoOrbit{};
  return std::move(*point);
}

BranchEvent event_between(EventKind kind, const BranchPoint& a, const BranchPoint& b) {
  return {kind, b, std::abs(b.parameter - a.parameter) / 2, {}};
}

/// The root of a test that has opposite signs at both ends of the segment. Where an orbit on the way cannot be
/// found, the event stands at the end with the whole segment as its error.
BranchEvent locate_root(EventKind kind, const Segment& segment, Test test, const BranchPoint& from,
                        const BranchPoint& to) {
  std::uintmax_t evaluations = root_evaluations;
  try {
    const auto [low, high] = boost::math::tools::toms748_solve(
        [&](double s) { return test(orbit_at(segment, s)); }, 0.0, segment.length(), test(from), test(to),
        [](double a, double b) { return std::abs(b - a) <= root_width; }, evaluations);
    return event_between(kind, orbit_at(segment, low), orbit_at(segment, high));
  } catch (const NoOrbit&) {
    return event_between(kind, from, to);
  }
}

/// The place where `changed` turns true, between an end where it is false and one where it is true.
BranchEvent bisect(EventKind kind, const Segment& segment, const BranchPoint& from, const BranchPoint& to,
                   const std::function<bool(const BranchPoint&)>& changed) {
  double low = 0, high = segment.length();
  BranchPoint below = from, above = to;
  while (high - low > root_width) {
    const double middle = (low + high) / 2;
    auto point = segment.at(middle);
    if (!point || middle <= low || middle >= high) break;
    if (changed(*point)) {
      high = middle;
      above = std::move(*point);
    } else {
      low = middle;
      below = std::move(*point);
    }
  }
  return event_between(kind, below, above);
}

bool opposite(double a, double b) { return (a < 0) != (b < 0); }

/// Where the turns of the orbit are those of one with a shorter period, the turn of the branch is not a fold.
bool has_shorter_period(const OrbitProblem& problem, const BranchPoint& point) {
  constexpr double same = 1e-4;
  if (problem.order == 1 || !problem.turns) return false;
  const auto sections = problem.turns(point.parameter, point.state);
  for (std::size_t k = 1; k < sections.size(); ++k) {
    if ((sections[k] - point.state).cwiseAbs().maxCoeff() < same) return true;
  }
  return false;
}

class Finder {
 public:
  Finder(const OrbitProblem& problem, const BranchPoint& from, const BranchPoint& to)
      : problem_(problem), from_(from), to_(to), segment_(problem, from, to) {}

  std::vector<BranchEvent> all() {
    if (!(segment_.length() > 0)) return {};
    find_turns();
    find_doublings();
    find_tori();
    if (!stability_explained()) {
      events_.push_back(bisect(EventKind::stability, segment_, from_, to_,
                               [&](const BranchPoint& point) { return point.unstable != from_.unstable; }));
    }
    for (BranchEvent& graze : grazes_between(problem_, from_, to_)) events_.push_back(std::move(graze));
    std::ranges::stable_sort(events_, {}, [](const BranchEvent& event) { return event.point.arclength; });
    return std::move(events_);
  }

 private:
  bool find(EventKind kind, Test test) {
    if (!opposite(test(from_), test(to_))) return false;
    events_.push_back(locate_root(kind, segment_, test, from_, to_));
    return true;
  }

  bool stability_explained() const {
    const int change = std::abs(to_.unstable - from_.unstable);
    return change <= single_ + 2 * pairs_ && (change - single_) % 2 == 0;
  }

  void find_turns() {
    const bool turns = find(EventKind::fold, fold_test);
    if (turns && has_shorter_period(problem_, events_.back().point)) {
      events_.back().kind = EventKind::period_halving;
      ++single_;
      return;  // its bordered determinant changes sign as well
    }
    const bool branches = find(EventKind::branch_point, branching_test);
    if (turns || branches) ++single_;
  }

  void find_doublings() {
    if (find(EventKind::period_doubling, doubling_test_of)) ++single_;
  }

  void find_tori() {
    if (!find(EventKind::neimark_sacker, torus_test_of)) return;
    if (nearest_pair_is_complex(events_.back().point.multipliers)) {
      ++pairs_;
    } else {
      events_.pop_back();  // two real multipliers whose product is 1
    }
  }

  const OrbitProblem& problem_;
  const BranchPoint &from_, &to_;
  Segment segment_;
  std::vector<BranchEvent> events_;
  int single_ = 0, pairs_ = 0;  ///< multipliers, and complex pairs of them, that passed the unit circle
};

}  // namespace

std::vector<BranchEvent> events_between(const OrbitProblem& problem, const BranchPoint& from,
                                        const BranchPoint& to) {
  return Finder(problem, from, to).all();
}

}  // namespace rubsweep::branch
