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

/// Smooth functions of the multipliers: zero where a multiplier is +1, where one is -1, or where a pair has
/// the product 1. The struct also holds the slopes of these functions along a branch.
struct MultiplierTests {
  double unit = 0, doubling = 0, torus = 0;
};

/// Function that varies smoothly along a branch and belongs to one place of the orbit. Its zero marks a
/// change in the sequence of contact modes.
struct Margin {
  enum class Kind {
    approach,  ///< distance of an Approach
    stretch,   ///< squared duration, in shaft rotation, of a stretch between two changes at one contact
  };
  Kind kind = Kind::approach;
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;  ///< first change of the stretch
  double phase_rad = 0;
  double value = 0;  ///< >= 0
  double slope = 0;  ///< slope per unit of arclength

  bool is_like(const Margin& other) const {
    return kind == other.kind && contact == other.contact && from == other.from && to == other.to;
  }
};

/// Step of central differences by the parameter, in its coordinate. The noise of a turn (1e-13) and the
/// truncation error each cause errors near 1e-7. Near a graze the step is smaller, because it must not cross
/// the graze.
inline constexpr double usual_difference_step = 1e-6;

/// Orbit on a branch. Continuation measures lengths in the coordinates (state / sqrt(states), parameter /
/// parameter_scale).
struct BranchPoint {
  double parameter = 0;
  double arclength = 0;  ///< length from the start orbit; < 0 on the side of falling parameter
  Eigen::VectorXd state;
  Eigen::VectorXd tangent;  ///< unit vector along the branch in the coordinates above; parameter last
  Eigen::MatrixXd monodromy;
  Eigen::VectorXcd multipliers;  ///< multipliers of the orbit, the largest modulus first
  int unstable = 0;              ///< number of multipliers outside the unit circle
  double branching = 0;  ///< determinant of the bordered derivative, which changes sign at branch points
  double slope_difference = 0;  ///< relative difference of the parameter derivatives at two step sizes
  double difference_step = usual_difference_step;  ///< step size of the derivative by the parameter
  std::optional<MultiplierTests> slopes;           ///< slopes per unit of arclength, if they were needed
  std::optional<std::vector<Margin>> margins;      ///< margins, if they were needed
  orbits::OrbitFacts facts;

  bool stable() const { return unstable == 0; }
};

/// Kind of codimension-one point on a branch.
enum class EventKind {
  fold,             ///< the branch turns back in the parameter: a multiplier passes +1
  period_doubling,  ///< a multiplier passes -1
  neimark_sacker,   ///< a pair of complex multipliers leaves or enters the unit circle: a torus
  /// a multiplier passes +1, but the parameter does not turn back: a symmetry breaks, or branches cross
  branch_point,
  period_halving,  ///< the branch joins the branch of half its period, and runs back shifted by half a period
  graze,           ///< a hit or a pair of changes of contact mode appears or disappears
  sequence,        ///< any other change of the sequence of contact modes
  stability,       ///< multipliers cross the unit circle without one of the events above
};

constexpr std::string_view to_string(EventKind kind) { return enumerator_word(kind); }

struct BranchEvent {
  EventKind kind = EventKind::fold;
  BranchPoint point;
  double parameter_error =
      0;               ///< half-width of the interval that encloses the root, in units of the parameter
  std::string detail;  ///< graze: contact, and what appears or disappears with growing arclength
  std::optional<orbits::SequenceChange> change = {};  ///< graze: change of the contact sequence
};

/// Reason why a branch ends.
enum class Ending {
  left_range,      ///< the parameter reaches the end of its range; the last point is there
  closed,          ///< back at the start: the branch is a closed curve
  off_the_walls,   ///< the contact ends at a graze: beyond it the orbit is the quiet motion
  period_halving,  ///< the branch joins the branch of half its period
  infeasible,      ///< there is no machine or scene for parameters beyond
  failed,          ///< the solver cannot make a turn
  step_too_small,  ///< Newton's iteration finds no orbit even close to the last one
  singular,        ///< the tangent of the branch cannot be determined
  point_limit,
  resonance,     ///< curve of tori: at a 1:1 or 1:2 resonance both multipliers become real
  unfolds,       ///< curve of branch points: branches no longer cross when the second parameter changes
  first_change,  ///< stability changed, and `stop_at_first_change` was set
  target,        ///< the wanted parameter is reached
};

constexpr std::string_view to_string(Ending ending) { return enumerator_word(ending); }

/// One half of a branch, from its start in one direction.
struct HalfBranch {
  std::vector<BranchPoint> points;  ///< points from the start on
  std::vector<BranchEvent> events;  ///< events in the order in which they occur
  Ending ending = Ending::left_range;
};

/// Branch in both directions: points and events by ascending arclength.
struct Branch {
  int order = 1;
  std::vector<BranchPoint> points;
  std::vector<BranchEvent> events;
  Ending falling = Ending::left_range,
         rising = Ending::left_range;  ///< endings at the first and at the last point
};

/// Comment lines for both files: meaning of the parameter, and ending of each branch.
std::string branch_comments(const std::string& parameter, const std::vector<Branch>& branches);

/// Table with a header and a row for every point, branch by branch, by ascending arclength.
std::string branch_csv(const std::vector<Branch>& branches);

/// Table with a header and a row for every event, branch by branch, by ascending arclength.
std::string branch_events_csv(const std::vector<Branch>& branches);

/// Summary for a terminal: the extent of each branch, and its events.
std::string branch_summary(const std::string& parameter, const std::vector<Branch>& branches);

}  // namespace rubsweep::branch::continuation
