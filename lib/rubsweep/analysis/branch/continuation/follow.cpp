#include "rubsweep/analysis/branch/continuation/follow.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rubsweep/analysis/branch/continuation/bifurcations.hpp"
#include "rubsweep/analysis/branch/continuation/continuation.hpp"
#include "rubsweep/analysis/branch/continuation/even_graze.hpp"
#include "rubsweep/analysis/branch/continuation/margins.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// Null vector of monodromy + 1: unit vector whose sign changes every period.
Eigen::VectorXd alternating(const Eigen::MatrixXd& monodromy) {
  const Eigen::Index n = monodromy.rows();
  const Eigen::MatrixXd sum = monodromy + Eigen::MatrixXd::Identity(n, n);
  return numerics::spectral::singular_values(sum).v.col(n - 1);
}

bool in_range(const orbits::OrbitProblem& problem, double parameter) {
  return parameter >= problem.low && parameter <= problem.high;
}

/// Whether the turns of the orbit repeat before its period ends. The tolerance is the error of Newton's
/// iteration near the point where a branch joins a branch of a shorter period.
bool repeats_sooner(const BranchPoint& point) {
  constexpr double same = 1e-6;
  const auto& sections = point.facts.sections;
  for (std::size_t k = 1; k < sections.size(); ++k) {
    if (sections.size() % k == 0 && (sections[k] - point.state).cwiseAbs().maxCoeff() < same) return true;
  }
  return false;
}

/// Continuation of orbits by one parameter.
class OrbitTask {
 public:
  using Point = BranchPoint;
  using Event = BranchEvent;
  using Half = HalfBranch;
  using Correction = continuation::Correction;
  static constexpr int easy_iterations = 4;

  OrbitTask(const orbits::OrbitProblem& problem, const FollowOptions& options)
      : problem_(problem), options_(options) {}

  const orbits::OrbitProblem& problem() const { return problem_; }

  bool holds(const Correction& found) const { return in_range(problem_, found.point.parameter); }

  std::optional<Correction> correct_at_edge(const BranchPoint& here, const Correction& found) const {
    const BranchPoint& beyond = found.point;
    const double parameter = std::clamp(beyond.parameter, problem_.low, problem_.high);
    if (here.parameter == parameter) return std::nullopt;
    const double share = (parameter - here.parameter) / (beyond.parameter - here.parameter);
    Correction last = correct_at(problem_, here.state + share * (beyond.state - here.state), parameter);
    last.point.parameter = parameter;  // exact value, without the rounding of its coordinate
    return last;
  }

  /// Refuses a step onto an orbit of a shorter period. Every such orbit also solves the equations of twice
  /// its period, so that such a step has left the branch.
  static std::optional<Ending> refuses(const BranchPoint& here, const BranchPoint& next) {
    if (repeats_sooner(next) && !repeats_sooner(here)) return Ending::step_too_small;
    return std::nullopt;
  }

  void prepare(BranchPoint& next) const {
    next.slopes = multiplier_slopes(problem_, next);
    if (options_.every_graze) next.margins = margins_of(problem_, next);
  }

  std::optional<std::vector<BranchEvent>> events_between(const BranchPoint& from,
                                                         const BranchPoint& to) const {
    if (even_contact_changes(from, to)) return std::nullopt;  // around a corner
    return continuation::events_between(problem_, from, to, options_.every_graze);
  }

  std::optional<EvenGraze> corner_ahead(const BranchPoint& here, double step) const {
    auto corner = even_graze_ahead(problem_, here, step);
    if (!corner) return std::nullopt;
    for (BranchPoint* point : {&corner->before, corner->beyond ? &*corner->beyond : nullptr})
      if (point != nullptr) prepare(*point);
    return corner;
  }

  std::optional<Ending> ending_at(const BranchPoint& start, const BranchEvent& event) const {
    if (event.kind == EventKind::period_halving) return Ending::period_halving;
    if (event.kind == EventKind::graze && start.facts.touched && !event.point.facts.touched)
      return Ending::off_the_walls;
    const bool changes = event.kind != EventKind::graze && event.kind != EventKind::sequence;
    if (options_.stop_at_first_change && changes) return Ending::first_change;
    return std::nullopt;
  }

  std::vector<Position> images(const BranchPoint& point) const {
    if (!problem_.facts) return {position_of(problem_, point)};
    std::vector<Position> images;
    for (const Eigen::VectorXd& state : point.facts.sections)
      images.push_back(position_of(problem_, state, point.parameter));
    return images;
  }

 private:
  const orbits::OrbitProblem& problem_;
  const FollowOptions& options_;
};

}  // namespace

std::optional<BranchPoint> doubled_start(const orbits::OrbitProblem& doubled, const BranchPoint& doubling) {
  const Position here = position_of(doubled, doubling);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(here.size());
  direction.head(here.size() - 1) = alternating(doubling.monodromy);
  for (const double distance : {1e-4, 1e-5, 3e-4, 1e-3}) {
    const Correction found = correct(doubled, here + distance * direction, direction);
    if (!found.converged) continue;
    if ((position_of(doubled, found.point) - here).norm() > 3 * distance) continue;
    auto start = completed(doubled, found, direction, 0);
    if (start) return start;
  }
  return std::nullopt;
}

std::optional<BranchPoint> orbit_from(const orbits::OrbitProblem& problem, const Eigen::VectorXd& state,
                                      double parameter) {
  const Correction found = correct_at(problem, state, parameter);
  if (!found.converged) return std::nullopt;
  Eigen::VectorXd along_parameter = Eigen::VectorXd::Zero(state.size() + 1);
  along_parameter(state.size()) = 1;
  return completed(problem, found, along_parameter, 0);
}

BranchPoint turned_about(BranchPoint point) {
  point.tangent = -point.tangent;
  point.branching = -point.branching;  // the reversed tangent is a row of this determinant
  if (point.slopes) point.slopes = {-point.slopes->unit, -point.slopes->doubling, -point.slopes->torus};
  return point;
}

HalfBranch follow(const orbits::OrbitProblem& problem, const BranchPoint& start,
                  const FollowOptions& options) {
  const OrbitTask task(problem, options);
  return Continuation<OrbitTask>(task, start, options).run();
}

Branch follow_both_ways(const orbits::OrbitProblem& problem, const BranchPoint& start,
                        const FollowOptions& options) {
  auto [all, falling] = continue_both_ways(OrbitTask(problem, options), start, options);
  return {problem.order, std::move(all.points), std::move(all.events), falling, all.ending};
}

}  // namespace rubsweep::branch::continuation
