#include "rubsweep/analysis/branch/continuation/bifurcations.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/branch/continuation/graze.hpp"
#include "rubsweep/analysis/branch/continuation/margins.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/continuation/segment.hpp"
#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

namespace rubsweep::branch::continuation {
namespace {

using OrbitSegment = Segment<orbits::OrbitProblem, BranchPoint>;
using OrbitTest = EventTest<EventKind, BranchPoint>;

/// Limits on halving a step in search of two roots: number of divisions, and length of the shortest part.
constexpr int most_parted = 6;
constexpr double shortest_parted = 1e-6;

double fold_test(const BranchPoint& point) { return point.tangent(point.tangent.size() - 1); }
double branching_test(const BranchPoint& point) { return point.branching; }
double doubling_test_of(const BranchPoint& point) { return orbits::doubling_test(point.multipliers); }
double torus_test_of(const BranchPoint& point) { return orbits::torus_test(point.multipliers); }

BranchEvent event_between(const orbits::OrbitProblem& problem, EventKind kind, const BranchPoint& a,
                          const BranchPoint& b) {
  if (!continuous(problem, a, b)) throw NotContinuous{};
  return {kind, b, std::abs(b.parameter - a.parameter) / 2 + rounding_of_parameter(problem, b), {}};
}

/// Difference of the states at half a period and at the start.
Eigen::VectorXd half_period_difference(const BranchPoint& point) {
  return point.facts.sections[point.facts.sections.size() / 2] - point.state;
}

bool opposite(double a, double b) { return (a < 0) != (b < 0); }

/// Locates an orbit where the branch joins the branch of half its period. The branch crosses itself there, so
/// that Newton's iteration for the whole period is inaccurate. The orbit of half the period is regular there.
/// It has a period doubling, which can be located to rounding.
void sharpen_halving(const orbits::OrbitProblem& problem, BranchEvent& halving) {
  constexpr double reach = 1e-4;  ///< half-width of the searched range, in units of the parameter's scale
  if (!problem.half_returns) return;
  orbits::OrbitProblem half = problem;
  half.returns = problem.half_returns;
  half.order = problem.order / 2;
  Eigen::VectorXd state = halving.point.state;
  const auto test = [&](double parameter) {
    const Correction found = correct_at(half, state, parameter);
    if (!found.converged) throw NotContinuous{};
    return orbits::doubling_test(orbits::multipliers_of(found.point.monodromy));
  };
  const double low = halving.point.parameter - reach * problem.parameter_scale,
               high = halving.point.parameter + reach * problem.parameter_scale;
  try {
    const double at_low = test(low), at_high = test(high);
    if (!opposite(at_low, at_high)) return;
    std::uintmax_t evaluations = 100;
    const auto [below, above] = boost::math::tools::toms748_solve(
        test, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(48), evaluations);
    halving.point.parameter = (below + above) / 2;
    halving.parameter_error = (above - below) / 2;
  } catch (const NotContinuous&) {
    return;  // the event keeps the position that was found first
  }
}

/// Search for all events between two points.
class Finder {
 public:
  Finder(const orbits::OrbitProblem& problem, const BranchPoint& from, const BranchPoint& to)
      : problem_(problem), from_(from), to_(to), segment_(problem, from, to) {
    if (!(segment_.length() > 0)) throw NotContinuous{};
  }

  /// Orbit that divides the step in two, because one of the test functions may have two roots in the step.
  std::optional<BranchPoint> between_a_pair(bool every_graze) const {
    if (segment_.length() < shortest_parted || is_about_half_period()) return std::nullopt;
    auto share = share_of_a_pair();
    if (!share && every_graze) share = share_of_two_grazes();
    if (share) return segment_.required_at(*share * segment_.length());
    return std::nullopt;
  }

  std::vector<BranchEvent> all(bool every_graze) {
    if (!joins_half_period()) {
      find({EventKind::fold, fold_test});
      find({EventKind::branch_point, branching_test});
    }
    find({EventKind::period_doubling, doubling_test_of});
    find_tori();
    if (!stability_explained()) find_change_of_stability();
    if (every_graze || from_.facts.touched != to_.facts.touched) find_grazes();
    std::ranges::stable_sort(events_, {}, [](const BranchEvent& event) { return event.point.arclength; });
    return std::move(events_);
  }

 private:
  bool find(const OrbitTest& test) {
    const auto root = root_on(segment_, test.value);
    if (!root) return false;
    events_.push_back(event_between(problem_, test.kind, segment_.required_at(root->low),
                                    segment_.required_at(root->high)));
    return true;
  }

  /// Position in the step at which a test function may have two roots. Functions of the multipliers are
  /// approximated by cubics through their values and slopes. The fold function (the tangent's parameter
  /// component) is approximated from its values at both ends and the change of the parameter.
  std::optional<double> share_of_a_pair() const {
    const double length = segment_.length(), cosine = from_.tangent.dot(to_.tangent);
    if (!(cosine > 0)) return std::nullopt;
    const double mean = (to_.parameter - from_.parameter) / problem_.parameter_scale / length;
    if (const auto share = dip_of_quadratic(fold_test(from_), fold_test(to_) / cosine, mean)) return share;
    const MultiplierTests begin = tests_of_multipliers(from_.multipliers),
                          end = tests_of_multipliers(to_.multipliers),
                          out = from_.slopes ? *from_.slopes : multiplier_slopes(problem_, from_),
                          in = to_.slopes ? *to_.slopes : multiplier_slopes(problem_, to_);
    for (const auto test : {&MultiplierTests::unit, &MultiplierTests::doubling, &MultiplierTests::torus}) {
      const StepEnds ends{begin.*test, end.*test, out.*test, in.*test / cosine};
      if (const auto share = dip_of_cubic(ends, length)) return share;
    }
    return std::nullopt;
  }

  std::optional<double> share_of_two_grazes() const {
    const double cosine = from_.tangent.dot(to_.tangent);
    if (!problem_.passages || !(cosine > 0)) return std::nullopt;
    return share_of_dip(from_.margins ? *from_.margins : margins_of(problem_, from_),
                        to_.margins ? *to_.margins : margins_of(problem_, to_),
                        2 * std::numbers::pi * problem_.order, segment_.length(), cosine);
  }

  bool has_half_period() const {
    const auto has = [](const BranchPoint& point) {
      return !point.facts.sections.empty() && point.facts.sections.size() % 2 == 0;
    };
    return has(from_) && has(to_);
  }

  bool is_about_half_period() const {
    return has_half_period() && half_period_difference(from_).dot(half_period_difference(to_)) < 0;
  }

  /// Finds where the branch joins the branch of half the period. Beyond this point the branch repeats itself
  /// backwards, shifted by half a period, so the turning point is no fold.
  bool joins_half_period() {
    if (!has_half_period()) return false;
    const Eigen::VectorXd before = half_period_difference(from_).normalized();
    if (!find({EventKind::period_halving,
               [&](const BranchPoint& point) { return before.dot(half_period_difference(point)); }}))
      return false;
    sharpen_halving(problem_, events_.back());
    return true;
  }

  void find_grazes() {
    auto grazes = grazes_between(problem_, from_, to_);
    if (!grazes) throw NotContinuous{};
    std::ranges::move(*grazes, std::back_inserter(events_));
  }

  void find_change_of_stability() {
    const auto [at, before, behind] = change_on(
        segment_, 0, from_, [&](const BranchPoint& point) { return point.unstable != from_.unstable; });
    events_.push_back(event_between(problem_, EventKind::stability, before, behind));
  }

  bool has(EventKind kind) const {
    return std::ranges::find(events_, kind, &BranchEvent::kind) != events_.end();
  }

  /// Whether the events found explain the change of `unstable`: multipliers cross the circle alone or in
  /// pairs.
  bool stability_explained() const {
    const int turns = has(EventKind::fold) || has(EventKind::branch_point);
    const int single = turns + has(EventKind::period_halving) + has(EventKind::period_doubling);
    const int pairs = has(EventKind::neimark_sacker);
    const int change = std::abs(to_.unstable - from_.unstable);
    return change <= single + 2 * pairs && (change - single) % 2 == 0;
  }

  /// Finds tori. The test function is also zero for two real multipliers whose product is 1, which is no
  /// torus.
  void find_tori() {
    if (find({EventKind::neimark_sacker, torus_test_of}) &&
        !orbits::nearest_pair_is_complex(events_.back().point.multipliers))
      events_.pop_back();
  }

  const orbits::OrbitProblem& problem_;
  const BranchPoint &from_, &to_;
  OrbitSegment segment_;
  std::vector<BranchEvent> events_;
};

/// `parted`: number of times that the step was divided so far.
std::vector<BranchEvent> events_of_piece(const orbits::OrbitProblem& problem, const BranchPoint& from,
                                         const BranchPoint& to, bool every_graze, int parted) {
  Finder finder(problem, from, to);
  auto middle = parted < most_parted ? finder.between_a_pair(every_graze) : std::nullopt;
  if (!middle) return finder.all(every_graze);
  middle->slopes = multiplier_slopes(problem, *middle);
  if (every_graze) middle->margins = margins_of(problem, *middle);
  auto events = events_of_piece(problem, from, *middle, every_graze, parted + 1);
  std::ranges::move(events_of_piece(problem, *middle, to, every_graze, parted + 1),
                    std::back_inserter(events));
  return events;
}

}  // namespace

std::optional<std::vector<BranchEvent>> events_between(const orbits::OrbitProblem& problem,
                                                       const BranchPoint& from, const BranchPoint& to,
                                                       bool every_graze) {
  try {
    return events_of_piece(problem, from, to, every_graze, 0);
  } catch (const NotContinuous&) {
    return std::nullopt;
  }
}

}  // namespace rubsweep::branch::continuation
