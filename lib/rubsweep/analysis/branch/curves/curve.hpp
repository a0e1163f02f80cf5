#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/analysis/branch/curves/extended_system.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::branch::curves {

/// An orbit on a curve in the plane of two parameters. Lengths are those of the coordinates of its system.
struct CurvePoint {
  orbits::PlanePoint place;
  double arclength = 0;  ///< length from the event that the curve starts from; below 0 on its other side
  Eigen::VectorXd state;
  continuation::Position at;       ///< place and state in the coordinates
  continuation::Position tangent;  ///< unit vector along the curve
  double error = 0;              ///< the last Newton correction of the parameters, in shares of their ranges
  Eigen::VectorXcd multipliers;  ///< largest modulus first
  Critical critical;
  orbits::OrbitFacts facts;
};

/// Where a curve meets another one: two things happen at one place of the plane.
enum class MeetingKind {
  cusp,                  ///< two curves of folds end in each other
  fold_flip,             ///< multipliers +1 and -1
  fold_torus,            ///< +1 and a complex pair on the unit circle
  flip_torus,            ///< -1 and such a pair
  double_torus,          ///< two such pairs
  resonance_1_1,         ///< +1 twice, where a curve of tori begins at one of folds
  resonance_1_2,         ///< -1 twice, where one begins at a period doubling
  resonance_1_3,         ///< a pair at 120 degrees
  resonance_1_4,         ///< a pair at 90 degrees
  generalised_flip,      ///< a period doubling changes from soft to hard
  degenerate_branching,  ///< a break of symmetry changes from soft to hard
  graze_fold,            ///< an orbit that grazes has a multiplier +1
  graze_flip,            ///< -1
  graze_torus,           ///< a complex pair on the unit circle
  double_graze,          ///< two grazes at once
  degenerate_graze,      ///< the grazing guard does not turn back: its second derivative is zero as well
};

constexpr std::string_view to_string(MeetingKind kind) { return enumerator_word(kind); }

struct Meeting {
  MeetingKind kind = MeetingKind::cusp;
  CurvePoint point;
  double error = 0;  ///< half-width, along the curve, of the interval in which the root was enclosed
};

/// One side of a curve: from its start on.
struct HalfCurve {
  std::vector<CurvePoint> points;  ///< the start first
  std::vector<Meeting> events;     ///< meetings in the order in which they are met
  continuation::Ending ending = continuation::Ending::left_range;
};

/// A curve both ways: points and meetings by ascending arclength.
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

/// Newton's iteration from `guess` on the plane direction . (position - guess) = 0, to rounding.
CurveCorrection correct(const ExtendedSystem& system, const continuation::Position& guess,
                        const continuation::Position& direction);

/// The same from a guess between two points of a curve, across the tangent of the first.
inline CurveCorrection correct_between(const ExtendedSystem& system, const continuation::Position& guess,
                                       const CurvePoint& from, const CurvePoint& /*to*/) {
  return correct(system, guess, from.tangent);
}

/// The point that Newton's iteration found, with its tangent on the side of `direction`, its multipliers and
/// its facts. Empty where the tangent cannot be told, or the orbit not be run.
std::optional<CurvePoint> completed(const ExtendedSystem& system, const CurveCorrection& found,
                                    const continuation::Position& direction, double arclength);

inline const continuation::Position& position_of(const ExtendedSystem&, const CurvePoint& point) {
  return point.at;
}
inline const continuation::Position& position_of(const ExtendedSystem&, const CurveCorrection& found) {
  return found.at;
}

/// `position` with the phase of a graze moved by whole turns to be next to that of `near`.
continuation::Position nearest_image(const ExtendedSystem& system, continuation::Position position,
                                     const CurvePoint& near);

/// The same point with its curve the other way round.
CurvePoint turned_about(CurvePoint point);

}  // namespace rubsweep::branch::curves
