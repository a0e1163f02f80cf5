#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/run/outcome.hpp"

namespace rubsweep::integrate::run {

/// A change of contact mode, `phase_rad` into the revolution.
struct ModeSwitch {
  double phase_rad = 0;
  int contact = 0;
  contact::Mode from = contact::Mode::open;
  contact::Mode to = contact::Mode::open;
  /// Damping that a curved law has from here on, per scaled closing speed; 0 of all others.
  double impact_damping = 0;
};

/// Work done since the start of the run.
struct Effort {
  long rhs_calls = 0;
  long steps = 0;    ///< accepted
  long refused = 0;  ///< refused by the error control
  long switches = 0;
  long implicit_steps = 0;  ///< accepted ones that Stepper::automatic took with rosenbrock4
  long taylor_turns = 0;    ///< revolutions with pieces of Taylor series, where there is no closed form
  long taylor_pieces = 0;   ///< such pieces, part of the steps
  long creep_pieces = 0;    ///< of these, such in which steep friction holds a slip
  /// Work of these pieces in expansions of the motion: one each, sweeps that find a slip held by steep
  /// friction, and a third of one for each expansion of a tangent vector.
  double taylor_work = 0;
  long adaptive_turns = 0;  ///< revolutions without a closed form, by a stepper
};

/// Request for one revolution; it may stay the same from turn to turn. States are scaled and hold 2n
/// numbers: the displacements q in units of the scene's length scale L, then the velocities q' in units of L
/// * speed.
struct TurnRequest {
  int samples_per_revolution = 0;  ///< N: states at phases 2 pi k / N, k = 0..N-1; 0: none
  bool peaks = false;              ///< fill the peak_ numbers
  bool switches = false;           ///< list the changes of contact mode
  /// 2n x m (m <= 2n; 0: none): small changes of the section at the start, to be taken to the end of the turn
  /// by d(section at the end) / d(section at the start).
  Eigen::MatrixXd tangent_vectors{};
  /// Relative error that one step may add to them, where a step truncates anything.
  double tangent_accuracy = 4e-12;
};

/// Tangent vectors at the end of a turn, where the turn was asked for them and could move them. Its memory is
/// kept from turn to turn.
class MovedTangentVectors {
 public:
  /// 2n x m as asked. Null where none were asked for, and where the solver that made the turn moves none:
  /// whoever needs them there has to find them by another way.
  const Eigen::MatrixXd* get() const { return moved_ ? &vectors_ : nullptr; }

  void clear() { moved_ = false; }
  /// For the solver that moved them: all of it is to be written.
  Eigen::MatrixXd& fill(Eigen::Index states, Eigen::Index count) {
    moved_ = true;
    vectors_.resize(states, count);
    return vectors_;
  }

 private:
  bool moved_ = false;
  Eigen::MatrixXd vectors_;
};

/// Report of one revolution. Reused from turn to turn: every turn overwrites all of it.
struct TurnReport {
  std::vector<double> section;  ///< scaled state at the end of the turn, 2n; unchanged by a turn that fails
  std::vector<double> samples;  ///< sample_count x 2n in front, row by row
  int sample_count = 0;         ///< samples_per_revolution as asked; fewer only where the turn failed
  std::vector<ModeSwitch> switches;  ///< none by a smoothed law, which has no modes
  MovedTangentVectors tangent_vectors;
  int hits = 0;                 ///< open -> touching, all contacts together
  double contact_fraction = 0;  ///< share of the turn with at least one contact touching
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;        ///< largest normal force at any one contact
  double peak_casing_displacement_m = 0;  ///< largest distance of any casing from its unloaded place
  double peak_twist_rad = 0;              ///< largest angle between rotor and drive; 0 without torsion
  double peak_torque_nm = 0;              ///< largest torque in the drive; 0 without torsion
  bool touched = false;                   ///< some contact was touching at some time in the turn
  bool touching_at_end = false;
  bool slip_reversed = false;  ///< under one-way friction a slip speed was <= 0 while touching
  Effort effort;               ///< of the whole run so far

  /// Forgets all but the section and the effort.
  void clear() {
    sample_count = 0;
    switches.clear();
    tangent_vectors.clear();
    hits = 0;
    contact_fraction = peak_displacement_m = peak_contact_force_n = peak_casing_displacement_m = 0;
    peak_twist_rad = peak_torque_nm = 0;
    touched = touching_at_end = slip_reversed = false;
  }

  /// Counts a change of contact mode, and lists it where that is asked.
  void add(const ModeSwitch& change, bool listed) {
    if (change.from == contact::Mode::open) ++hits;
    if (listed) switches.push_back(change);
  }
};

/// Advances a run by exactly one revolution and fills the report. After an outcome other than ok the run is
/// over, and the report holds the completed part of the turn: samples, switches and effort.
using Cursor = std::function<Outcome(const TurnRequest&, TurnReport&)>;

/// A run that can be set back: `restart` puts it at the start of revolution 0 of its scene at another section
/// (as TurnReport::section), with no memory of what it did before.
struct Run {
  Cursor advance;
  std::function<void(std::span<const double>)> restart;
};

}  // namespace rubsweep::integrate::run
