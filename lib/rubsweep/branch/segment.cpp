#include "rubsweep/branch/segment.hpp"

#include <algorithm>
#include <utility>

#include "rubsweep/branch/hermite.hpp"

namespace rubsweep::branch {

Segment::Segment(const OrbitProblem& problem, const BranchPoint& from, const BranchPoint& to)
    : problem_(problem),
      from_(from),
      to_(to),
      begin_(position_of(problem, from)),
      end_(position_of(problem, to)),
      length_(from.tangent.dot(end_ - begin_)) {}

bool Segment::continuous(const OrbitProblem& problem, const BranchPoint& a, const BranchPoint& b) {
  constexpr double near = 1e-6;
  return (position_of(problem, a) - position_of(problem, b)).norm() < near;
}

std::optional<BranchPoint> Segment::at(double s) const {
  if (s <= 0) return from_;
  if (s >= length_) return to_;
  const Position on_plane = hermite_guess({begin_, from_.tangent}, {end_, to_.tangent}, length_, s);
  const Correction found =
      correct(problem_, on_plane, from_.tangent, std::min(from_.difference_step, to_.difference_step));
  if (!found.converged) return std::nullopt;
  return completed(problem_, found.point, from_.tangent,
                   from_.arclength + s / length_ * (to_.arclength - from_.arclength));
}

std::optional<BranchPoint> completed(const OrbitProblem& problem, BranchPoint point,
                                     const Eigen::VectorXd& direction, double arclength) {
  point.arclength = arclength;
  if (!complete(problem, direction, point)) return std::nullopt;
  if (!problem.facts) return point;
  auto facts = problem.facts(point.parameter, point.state);
  if (!facts) return std::nullopt;
  point.facts = std::move(*facts);
  return point;
}

}  // namespace rubsweep::branch
