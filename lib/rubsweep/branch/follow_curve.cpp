#include "rubsweep/branch/follow_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "rubsweep/branch/curve_newton.hpp"
#include "rubsweep/branch/growing_half.hpp"
#include "rubsweep/branch/meetings.hpp"

namespace rubsweep::branch {
namespace {

constexpr int easy_iterations = 5;
constexpr double same_place = 1e-7;    ///< between positions
constexpr double still_closed = 1e-8;  ///< defect of an orbit at a branch point, per unit of its size

bool holds(const PlaneOrbits& orbits, const Place& place) {
  return orbits.first.holds(place.first) && orbits.second.holds(place.second);
}

/// The positions of a point as seen from each of its turns.
std::vector<Position> all_turns(const ExtendedSystem& system, const CurvePoint& point) {
  if (system.kind == EventKind::graze || point.facts.sections.empty()) return {point.at};
  std::vector<Position> turns;
  for (const Eigen::VectorXd& section : point.facts.sections)
    turns.push_back(position_of(system, point.place, section));
  return turns;
}

/// `at` with its phase, where it has one, moved by whole turns to be next to that of `near`.
Position wound_to(const ExtendedSystem& system, Position at, const Position& near) {
  constexpr double turn = 2 * std::numbers::pi;
  if (system.kind == EventKind::graze)
    at(system.states) += turn * std::round((near(system.states) - at(system.states)) / turn);
  return at;
}

/// The point on the piece from `a` to `b` of a curve that one of `positions` is, if one is.
std::optional<CurvePoint> one_between(const ExtendedSystem& system, const CurvePoint& a, const CurvePoint& b,
                                      const std::vector<Position>& positions) {
  const CurveSegment segment(system, a, b);
  for (const Position& position : positions) {
    const Position wanted = wound_to(system, position, a.at);
    const double ahead = a.tangent.dot(wanted - a.at);
    if (ahead < 0 || ahead > segment.length() || (wanted - a.at).norm() > 1.5 * segment.length()) continue;
    auto there = segment.at(ahead);
    if (there && (there->at - wanted).norm() < same_place) return there;
  }
  return std::nullopt;
}

class CurveFollower {
 public:
  CurveFollower(const ExtendedSystem& system, const CurvePoint& start, const CurveOptions& options)
      : system_(system), side_(start, options), start_turns_(all_turns(system, start)) {}

  HalfCurve run() {
    side_.grow([&] { make_step(); });
    return std::move(side_.half);
  }

 private:
  const CurvePoint& here() const { return side_.here(); }

  void make_step() {
    const Position guess = here().at + side_.step() * here().tangent;
    const CurveCorrection found = correct(system_, guess, here().tangent);
    if (found.evaluation == Evaluation::infeasible) return side_.shorten(Ending::infeasible);
    if (found.evaluation == Evaluation::failed) return side_.shorten(Ending::failed);
    if (found.singular) return side_.shorten(Ending::singular);
    if (!found.converged || side_.is_far((found.at - guess).norm()))
      return side_.shorten(Ending::step_too_small);
    if (!holds(*system_.orbits, place_of(system_, found.at))) return step_to_end_of_range(found.at);
    auto next = completed(system_, found, here().tangent, here().arclength + side_.step());
    if (!next) return side_.shorten(Ending::singular);
    const double turn = next->tangent.dot(here().tangent);
    if (side_.turns_sharply(turn)) return side_.shorten(Ending::step_too_small);
    if (unfolds(*next)) return side_.shorten(Ending::unfolds);
    if (!accept(std::move(*next))) return side_.shorten(Ending::step_too_small);
    side_.lengthen(turn, found.iterations <= easy_iterations);
  }

  bool unfolds(const CurvePoint& point) const {
    return std::abs(point.critical.open_defect) >
           still_closed * std::max(1.0, point.state.cwiseAbs().maxCoeff());
  }

  /// On the edge of the plane that the step has crossed: the first one, where it has crossed two.
  void step_to_end_of_range(const Position& beyond) {
    const PlaneOrbits& orbits = *system_.orbits;
    const Place outside = place_of(system_, beyond);
    const std::array values{outside.first, outside.second};
    const std::array ranges{orbits.first, orbits.second};
    const Eigen::Index plane = beyond.size() - 2;
    double share = 1, edge = 0;
    Eigen::Index crossed = plane;
    for (Eigen::Index k = 0; k < 2; ++k) {
      const auto& range = ranges[static_cast<std::size_t>(k)];
      const double value = values[static_cast<std::size_t>(k)], from = here().at(plane + k);
      if (range.holds(value)) continue;
      const double there = std::clamp(value, range.low, range.high) / range.width();
      const double part = (there - from) / (beyond(plane + k) - from);
      if (part > share) continue;
      share = part;
      edge = there;
      crossed = plane + k;
    }
    if (!(share > 0)) return side_.end(Ending::left_range);
    Position guess = here().at + share * (beyond - here().at);
    guess(crossed) = edge;
    Position direction = Position::Zero(beyond.size());
    direction(crossed) = 1;
    const CurveCorrection found = correct(system_, guess, direction);
    const double length = here().tangent.dot(found.at - here().at);
    if (!found.converged || !(length > 0) || length > 2 * side_.step())
      return side_.shorten(Ending::step_too_small);
    auto last = completed(system_, found, here().tangent, here().arclength + length);
    if (!last || !accept(std::move(*last))) return side_.shorten(Ending::step_too_small);
    if (!side_.ended()) side_.end(Ending::left_range);
  }

  /// False where what lies between here and `next` is not one piece of a curve.
  bool accept(CurvePoint next) {
    if (is_closed_by(next)) return true;
    auto meetings = meetings_between(system_, here(), next);
    if (!meetings) return false;
    for (Meeting& meeting : *meetings) {
      side_.half.meetings.push_back(std::move(meeting));
      if (ends_at(side_.half.meetings.back())) return true;
    }
    side_.half.points.push_back(std::move(next));
    return true;
  }

  bool ends_at(const Meeting& meeting) {
    if (system_.kind != EventKind::neimark_sacker ||
        (meeting.kind != MeetingKind::resonance_1_1 && meeting.kind != MeetingKind::resonance_1_2))
      return false;
    side_.half.points.push_back(meeting.point);
    side_.end(Ending::resonance);
    return true;
  }

  bool is_closed_by(const CurvePoint& next) {
    if (side_.half.points.size() < 3) return false;
    const auto there = one_between(system_, here(), next, start_turns_);
    if (!there) return false;
    if (auto meetings = meetings_between(system_, here(), *there))
      std::ranges::move(*meetings, std::back_inserter(side_.half.meetings));
    side_.half.points.push_back(*there);
    side_.end(Ending::closed);
    return true;
  }

  const ExtendedSystem& system_;
  GrowingHalf<HalfCurve> side_;
  std::vector<Position> start_turns_;
};

}  // namespace

Curve follow_curve(const ExtendedSystem& system, const CurvePoint& start, const CurveOptions& options) {
  HalfCurve forward = CurveFollower(system, start, options).run(), backward{{}, {}, forward.ending};
  if (forward.ending != Ending::closed) {
    CurvePoint turned = start;
    turned.tangent = -turned.tangent;
    backward = CurveFollower(system, turned, options).run();
    backward.points.erase(backward.points.begin());  // the start, which is the first of the other side
    for (CurvePoint& point : backward.points) point.tangent = -point.tangent;
    turn_about(backward.points, [](CurvePoint& point) -> CurvePoint& { return point; });
    turn_about(backward.meetings, [](Meeting& meeting) -> CurvePoint& { return meeting.point; });
  }
  return {system.kind,
          system.orbits->order,
          joined(std::move(backward.points), std::move(forward.points)),
          joined(std::move(backward.meetings), std::move(forward.meetings)),
          backward.ending,
          forward.ending};
}

bool lies_on(const ExtendedSystem& system, const Curve& curve, const CurvePoint& point) {
  const std::vector<Position> turns = all_turns(system, point);
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    if (one_between(system, curve.points[i - 1], curve.points[i], turns)) return true;
  return false;
}

}  // namespace rubsweep::branch
