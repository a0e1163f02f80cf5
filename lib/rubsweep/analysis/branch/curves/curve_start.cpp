#include "rubsweep/analysis/branch/curves/curve_start.hpp"

#include <algorithm>

#include "rubsweep/analysis/branch/curves/curve_newton.hpp"

namespace rubsweep::branch::curves {
namespace {

/// Farther from the event, in shares of the ranges, it is something else.
constexpr double same_event = 1e-5;

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
  // At the second parameter of the event, where it has been located.
  continuation::Position direction = continuation::Position::Zero(guess.size());
  direction(direction.size() - 1) = 1;
  const CurveCorrection found = correct(start.system, guess, direction);
  if (!found.converged || (found.at - guess).tail(2).norm() > same_event) return std::nullopt;
  auto point = completed(start.system, found, direction, 0);
  if (!point) return std::nullopt;
  start.point = std::move(*point);
  return start;
}

}  // namespace rubsweep::branch::curves
