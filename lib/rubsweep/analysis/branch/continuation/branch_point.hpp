#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/analysis/branch/orbits/contact_sequence.hpp"
#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/vocabulary.hpp"

namespace rubsweep::branch::continuation {

/// Smooth functions of the multipliers, which are zero where one of them is +1 or -1 or a pair has the
/// product 1; or their slopes along a branch.
struct MultiplierTests {
  double unit = 0, doubling = 0, torus = 0;
};

/// A smooth function along a branch which is zero where the sequence of contact modes changes at one place of
/// the orbit.
struct Margin {
  enum class Kind {
    approach,  ///< distance of an Approach
    stretch,   ///< squared duration, in shaft rotation, of a stretch between two changes at one contact
  };
  Kind kind = Kind::approach;
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;  ///< change that begins it
  double phase_rad = 0;
  double value = 0;  ///< >= 0
  double slope = 0;  ///< slope per unit of arclength

  bool is_like(const Margin& other) const {
    return kind == other.kind && contact == other.contact && from == other.from && to == other.to;
  }
};

/// Step of central differences by the parameter, in its coordinate: the noise of a turn, 1e-13, and the error
/// of the formula both stay near 1e-7. Beside a graze, which they must not lead over, they are finer.
inline constexpr double usual_difference_step = 1e-6;

/// An orbit on a branch. Continuation measures lengths in the coordinates (state / sqrt(states),
/// parameter / parameter_scale).
struct BranchPoint {
  double parameter = 0;
  double arclength = 0;  ///< along the branch from the start orbit, below 0 on the side of falling parameter
  Eigen::VectorXd state;
  Eigen::VectorXd tangent;  ///< unit vector along the branch in the coordinates above; parameter last
  Eigen::MatrixXd monodromy;
  Eigen::VectorXcd multipliers;  ///< largest modulus first
  int unstable = 0;              ///< multipliers outside the unit circle
  double branching = 0;  ///< determinant of the bordered derivative, which changes sign at branch points
  double slope_difference = 0;  ///< relative, of the derivatives by the parameter at two step sizes
  double difference_step = usual_difference_step;  ///< step of that derivative
  std::optional<MultiplierTests> slopes;           ///< slopes per unit of arclength, where they were needed
  std::optional<std::vector<Margin>> margins;      ///< where they were needed
  orbits::OrbitFacts facts;

  bool stable() const { return unstable == 0; }
};

/// Kind of codimension-one point on a branch.
enum class EventKind {
  fold,             ///< the branch turns back in the parameter: a multiplier passes +1
  period_doubling,  ///< a multiplier passes -1
  neimark_sacker,   ///< a pair of complex multipliers leaves or enters the unit circle: a torus
  branch_point,  ///< a multiplier passes +1 while the parameter goes on: a symmetry breaks, or branches cross
  period_halving,  ///< the branch joins that of an orbit of half its period, and runs back as its own shift
  graze,           ///< a hit or a pair of changes of contact mode appears or disappears
  sequence,        ///< the sequence of contact modes changes otherwise
  stability,       ///< multipliers leave or enter the unit circle in a way none of the above explains
};

constexpr std::string_view to_string(EventKind kind) { return enumerator_word(kind); }

struct BranchEvent {
  EventKind kind = EventKind::fold;
  BranchPoint point;
  double parameter_error =
      0;               ///< half-width of the interval in which the root was enclosed, in the parameter
  std::string detail;  ///< graze: contact, and what appears or disappears as the arclength grows
  std::optional<orbits::SequenceChange> change = {};  ///< change at a graze
};

/// Why a branch ends.
enum class Ending {
  left_range,      ///< the parameter reaches the end of its range; the last point is there
  closed,          ///< back at the start: the branch is a closed curve
  off_the_walls,   ///< no contact any more behind a graze: the orbit is the quiet motion from there on
  period_halving,  ///< end on the branch of an orbit of half the period
  infeasible,      ///< no machine or scene beyond
  failed,          ///< the solver cannot make a turn
  step_too_small,  ///< Newton's iteration finds no orbit however near the last one
  singular,        ///< no direction of the branch can be told
  point_limit,
  resonance,     ///< curve of tori: beyond a 1:1 or 1:2 resonance its two multipliers are real
  unfolds,       ///< curve of branch points: branches cross no longer when the second parameter changes
  first_change,  ///< stability was lost or regained, where following was to stop there
  target,        ///< the wanted parameter is reached
};

constexpr std::string_view to_string(Ending ending) { return enumerator_word(ending); }

/// One side of a branch: from its start on.
struct HalfBranch {
  std::vector<BranchPoint> points;  ///< the start first
  std::vector<BranchEvent> events;  ///< events in the order in which they are met
  Ending ending = Ending::left_range;
};

/// A branch both ways: points and events by ascending arclength.
struct Branch {
  int order = 1;
  std::vector<BranchPoint> points;
  std::vector<BranchEvent> events;
  Ending falling = Ending::left_range,
         rising = Ending::left_range;  ///< endings at the first and at the last point
};

/// `#` lines of both files: the meaning of the parameter, and the ending of each branch.
std::string branch_comments(const std::string& parameter, const std::vector<Branch>& branches);

/// Header and a row for every point, branch by branch, by ascending arclength.
std::string branch_csv(const std::vector<Branch>& branches);

/// Header and a row for every event, the same way.
std::string branch_events_csv(const std::vector<Branch>& branches);

/// Summary for a terminal: the extent of each branch, and its events.
std::string branch_summary(const std::string& parameter, const std::vector<Branch>& branches);

}  // namespace rubsweep::branch::continuation
