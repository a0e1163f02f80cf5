#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/curves/extended_system.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::branch::curves {

/// Orbit on a curve in the plane of two parameters. Lengths are in the coordinates of its system.
struct CurvePoint {
  orbits::PlanePoint place;
  double arclength = 0;  ///< length from the event where the curve starts; < 0 on the other side
  Eigen::VectorXd state;
  continuation::Position at;       ///< place and state in the coordinates
  continuation::Position tangent;  ///< unit vector along the curve
  double error = 0;              ///< the last Newton correction of the parameters, as a share of their ranges
  Eigen::VectorXcd multipliers;  ///< largest modulus first
  Critical critical;
  orbits::OrbitFacts facts;
};

/// Kinds of codimension-two points, where a curve meets another one.
enum class MeetingKind {
  cusp,           ///< two curves of folds end together
  fold_flip,      ///< multipliers +1 and -1
  fold_torus,     ///< multiplier +1 and a complex pair on the unit circle
  flip_torus,     ///< multiplier -1 and a complex pair on the unit circle
  double_torus,   ///< two complex pairs on the unit circle
  resonance_1_1,  ///< double multiplier +1, where a curve of tori begins on a curve of folds
  /// double multiplier -1, where a curve of tori begins on a curve of period doublings
  resonance_1_2,
  resonance_1_3,         ///< a complex pair at +-120 degrees on the unit circle
  resonance_1_4,         ///< a complex pair at +-90 degrees on the unit circle
  generalised_flip,      ///< a period doubling changes between supercritical and subcritical
  degenerate_branching,  ///< a symmetry breaking changes between supercritical and subcritical
  graze_fold,            ///< an orbit that grazes has a multiplier +1
  graze_flip,            ///< a grazing orbit has a multiplier -1
  graze_torus,           ///< a grazing orbit has a complex pair on the unit circle
  double_graze,          ///< two grazes at once
  degenerate_graze,      ///< the grazing guard has a zero second derivative: it does not turn back
};

constexpr std::string_view to_string(MeetingKind kind) { return enumerator_word(kind); }

struct Meeting {
  MeetingKind kind = MeetingKind::cusp;
  CurvePoint point;
  double error = 0;  ///< half-width, along the curve, of the interval that encloses the root
};

/// One half of a curve, from its start in one direction.
struct HalfCurve {
  std::vector<CurvePoint> points;  ///< points from the start on
  std::vector<Meeting> events;     ///< meetings in the order in which they occur
  continuation::Ending ending = continuation::Ending::left_range;
};

/// Curve in both directions: points and meetings by ascending arclength.
struct Curve {
  continuation::EventKind kind = continuation::EventKind::fold;
  int order = 1;
  std::vector<CurvePoint> points;
  std::vector<Meeting> meetings;
  continuation::Ending backward = continuation::Ending::left_range,
                       forward =
                           continuation::Ending::left_range;  ///< endings at the first and at the last point
};

/// Outcome of Newton's iteration on an extended system.
struct CurveCorrection : continuation::NewtonOutcome {
  continuation::Position at;
  Extended extended;  ///< system at `at`
  double error = 0;   ///< see CurvePoint
};

/// Newton's iteration from `guess` on the plane direction . (position - guess) = 0, down to rounding.
CurveCorrection correct(const ExtendedSystem& system, const continuation::Position& guess,
                        const continuation::Position& direction);

/// Newton's iteration from a guess between two points of a curve, on the plane across the tangent of `from`.
inline CurveCorrection correct_between(const ExtendedSystem& system, const continuation::Position& guess,
                                       const CurvePoint& from, const CurvePoint& /*to*/) {
  return correct(system, guess, from.tangent);
}

/// Completes a converged point: its tangent on the side of `direction`, its multipliers and its facts. Empty
/// where the tangent cannot be determined or the orbit cannot be run.
std::optional<CurvePoint> completed(const ExtendedSystem& system, const CurveCorrection& found,
                                    const continuation::Position& direction, double arclength);

inline const continuation::Position& position_of(const ExtendedSystem&, const CurvePoint& point) {
  return point.at;
}
inline const continuation::Position& position_of(const ExtendedSystem&, const CurveCorrection& found) {
  return found.at;
}

/// `position` with the phase of a graze moved by whole turns next to the phase of `near`.
continuation::Position nearest_image(const ExtendedSystem& system, continuation::Position position,
                                     const CurvePoint& near);

/// Reverses the tangent of a point.
CurvePoint turned_about(CurvePoint point);

}  // namespace rubsweep::branch::curves
