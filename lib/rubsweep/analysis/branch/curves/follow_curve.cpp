#include "rubsweep/analysis/branch/curves/follow_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/analysis/branch/continuation/continuation.hpp"
#include "rubsweep/analysis/branch/curves/meetings.hpp"

namespace rubsweep::branch::curves {
namespace {

/// Largest distance from the located event, as a share of the ranges, of a point that is the same event.
constexpr double same_event = 1e-5;

constexpr double still_closed = 1e-8;  ///< closing error of an orbit at a branch point, relative to its size

/// Positions of a point, one for each of its turns.
std::vector<continuation::Position> all_turns(const ExtendedSystem& system, const CurvePoint& point) {
  if (system.has_phase() || point.facts.sections.empty()) return {point.at};
  std::vector<continuation::Position> turns;
  for (const Eigen::VectorXd& section : point.facts.sections)
    turns.push_back(position_of(system, point.place, section));
  return turns;
}

/// Continuation of a curve in two parameters.
class CurveTask {
 public:
  using Point = CurvePoint;
  using Event = Meeting;
  using Half = HalfCurve;
  using Correction = CurveCorrection;
  static constexpr int easy_iterations = 5;

  explicit CurveTask(const ExtendedSystem& system) : system_(system) {}

  const ExtendedSystem& problem() const { return system_; }

  bool holds(const CurveCorrection& found) const {
    const orbits::PlaneOrbits& orbits = *system_.orbits;
    const orbits::PlanePoint place = place_of(system_, found.at);
    return orbits.first.holds(place.first) && orbits.second.holds(place.second);
  }

  /// Point on the edge of the plane that the step crossed; where it crossed two edges, on the first one.
  std::optional<CurveCorrection> correct_at_edge(const CurvePoint& here, const CurveCorrection& found) const {
    const orbits::PlaneOrbits& orbits = *system_.orbits;
    const continuation::Position& beyond = found.at;
    const orbits::PlanePoint outside = place_of(system_, beyond);
    const std::array values{outside.first, outside.second};
    const std::array ranges{orbits.first, orbits.second};
    const Eigen::Index plane = beyond.size() - 2;
    double share = 1, edge = 0;
    Eigen::Index crossed = plane;
    for (Eigen::Index k = 0; k < 2; ++k) {
      const auto& range = ranges[static_cast<std::size_t>(k)];
      const double value = values[static_cast<std::size_t>(k)], from = here.at(plane + k);
      if (range.holds(value)) continue;
      const double there = std::clamp(value, range.low, range.high) / range.width();
      const double part = (there - from) / (beyond(plane + k) - from);
      if (part > share) continue;
      share = part;
      edge = there;
      crossed = plane + k;
    }
    if (!(share > 0)) return std::nullopt;
    continuation::Position guess = here.at + share * (beyond - here.at);
    guess(crossed) = edge;
    continuation::Position direction = continuation::Position::Zero(beyond.size());
    direction(crossed) = 1;
    return correct(system_, guess, direction);
  }

  /// Refuses a point at which branches no longer cross.
  static std::optional<continuation::Ending> refuses(const CurvePoint& /*here*/, const CurvePoint& next) {
    const double size = std::max(1.0, next.state.cwiseAbs().maxCoeff());
    if (std::abs(next.critical.open_defect) > still_closed * size) return continuation::Ending::unfolds;
    return std::nullopt;
  }

  static void prepare(CurvePoint& /*next*/) {}

  std::optional<std::vector<Meeting>> events_between(const CurvePoint& from, const CurvePoint& to) const {
    return meetings_between(system_, from, to);
  }

  std::optional<continuation::Ending> ending_at(const CurvePoint& /*start*/, const Meeting& meeting) const {
    const bool real_beyond =
        meeting.kind == MeetingKind::resonance_1_1 || meeting.kind == MeetingKind::resonance_1_2;
    if (system_.kind == continuation::EventKind::neimark_sacker && real_beyond)
      return continuation::Ending::resonance;
    return std::nullopt;
  }

  std::vector<continuation::Position> images(const CurvePoint& point) const {
    return all_turns(system_, point);
  }

 private:
  const ExtendedSystem& system_;
};

}  // namespace

std::optional<CurveStart> curve_start(const orbits::PlaneOrbits& orbits,
                                      const continuation::BranchEvent& event,
                                      const orbits::PlanePoint& place) {
  if (!has_curve(event.kind)) return std::nullopt;
  CurveStart start{{&orbits, event.kind, event.point.state.size()}, {}};
  orbits::PlanePoint begin = place;
  Eigen::VectorXd state = event.point.state;
  if (event.kind == continuation::EventKind::graze) {
    if (!event.change || !orbits.guard) return std::nullopt;
    start.system.guard = {event.change->contact, event.change->from, event.change->to};
    start.system.even = event.change->kind == orbits::SequenceChange::Kind::even;
  }
  if (start.system.has_phase()) {
    if (!orbits.at_phase) return std::nullopt;
    begin.phase_rad = std::max(0.0, event.change->middle_rad);
    const auto touching = orbits.at_phase(place, state, begin.phase_rad);
    if (!touching) return std::nullopt;
    state = *touching;
  }
  const continuation::Position guess = position_of(start.system, begin, state);
  // The second parameter is fixed at the value at which the event was located.
  continuation::Position direction = continuation::Position::Zero(guess.size());
  direction(direction.size() - 1) = 1;
  const CurveCorrection found = correct(start.system, guess, direction);
  if (!found.converged || (found.at - guess).tail(2).norm() > same_event) return std::nullopt;
  auto point = completed(start.system, found, direction, 0);
  if (!point) return std::nullopt;
  start.point = std::move(*point);
  return start;
}

Curve follow_curve(const ExtendedSystem& system, const CurvePoint& start, const CurveOptions& options) {
  auto [all, backward] = continuation::continue_both_ways(CurveTask(system), start, options);
  return {system.kind, system.orbits->order, std::move(all.points), std::move(all.events), backward,
          all.ending};
}

bool lies_on(const ExtendedSystem& system, const Curve& curve, const CurvePoint& point) {
  const std::vector<continuation::Position> turns = all_turns(system, point);
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const continuation::Segment segment(system, curve.points[i - 1], curve.points[i]);
    if (std::ranges::any_of(
            turns, [&](const continuation::Position& turn) { return segment.through(turn).has_value(); }))
      return true;
  }
  return false;
}

}  // namespace rubsweep::branch::curves
