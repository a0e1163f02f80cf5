#pragma once

#include <Eigen/Core>
#include <functional>
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
  double impact_damping = 0;  ///< Damping of a curved law from here on, by scaled closing speed; otherwise 0.
};

/// Work done since the start of the run.
struct Effort {
  long rhs_calls = 0;
  long steps = 0;    ///< accepted steps
  long refused = 0;  ///< steps refused by the error control
  long switches = 0;
  long implicit_steps = 0;  ///< accepted steps that Stepper::automatic took with rosenbrock4
  long taylor_turns = 0;    ///< revolutions with Taylor pieces, where there is no closed form
  long taylor_pieces = 0;   ///< Taylor pieces, included in `steps`
  long creep_pieces = 0;    ///< Taylor pieces in which steep friction holds a slip
  /// Work of the Taylor pieces, in expansions of the motion: one for each piece, one for each further sweep
  /// that finds a slip held by steep friction, and a third of one for each expansion of a tangent vector.
  double taylor_work = 0;
  long adaptive_turns = 0;  ///< revolutions without a closed form, made by a stepper
};

/// Request for one revolution; it may be the same for all turns. States are scaled and hold 2n numbers: the
/// displacements q in units of the scene's length scale L, then the velocities q' in units of L * speed.
struct TurnRequest {
  int samples_per_revolution = 0;  ///< N: states at phases 2 pi k / N, k = 0..N-1; 0: none
  bool peaks = false;              ///< true: compute the peak_ numbers
  bool switches = false;           ///< true: list the changes of contact mode
  /// Small changes of the section at the start, 2n x m (m <= 2n; 0: none). They are multiplied by d(section
  /// at the end) / d(section at the start).
  Eigen::MatrixXd tangent_vectors{};
  /// Relative error that one step may add to the tangent vectors, where a step truncates a series.
  double tangent_accuracy = 4e-12;
};

/// Tangent vectors at the end of a turn, if requested and possible. Memory is kept from turn to turn.
class MovedTangentVectors {
 public:
  /// Matrix 2n x m as requested. Null if none were requested, or if the solver of the turn cannot move them;
  /// the caller must then use another method.
  const Eigen::MatrixXd* get() const { return moved_ ? &vectors_ : nullptr; }

  void clear() { moved_ = false; }
  /// For the solver: memory that must be written completely.
  Eigen::MatrixXd& fill(Eigen::Index states, Eigen::Index count) {
    moved_ = true;
    vectors_.resize(states, count);
    return vectors_;
  }

 private:
  bool moved_ = false;
  Eigen::MatrixXd vectors_;
};

/// Report of one revolution. It is reused: every turn overwrites all of it.
struct TurnReport {
  std::vector<double> section;       ///< scaled state at the end of the turn, 2n; unchanged if the turn fails
  std::vector<double> samples;       ///< first sample_count x 2n numbers, row by row
  int sample_count = 0;              ///< as requested; fewer only if the turn failed
  std::vector<ModeSwitch> switches;  ///< empty for a smoothed law, which has no modes
  MovedTangentVectors tangent_vectors;
  int hits = 0;                 ///< changes from open to touching, all contacts together
  double contact_fraction = 0;  ///< share of the turn with at least one contact touching
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;        ///< largest normal force of any contact
  double peak_casing_displacement_m = 0;  ///< largest distance of any casing from its unloaded position
  double peak_twist_rad = 0;              ///< largest angle between rotor and drive; 0 without torsion
  double peak_torque_nm = 0;              ///< largest torque in the drive; 0 without torsion
  bool touched = false;                   ///< some contact was touching at some time in the turn
  bool touching_at_end = false;
  bool slip_reversed = false;  ///< true: with one-way friction, a slip speed was <= 0 in contact
  Effort effort;               ///< work of the whole run so far

  /// Resets everything except the section and the effort.
  void clear() {
    sample_count = 0;
    switches.clear();
    tangent_vectors.clear();
    hits = 0;
    contact_fraction = peak_displacement_m = peak_contact_force_n = peak_casing_displacement_m = 0;
    peak_twist_rad = peak_torque_nm = 0;
    touched = touching_at_end = slip_reversed = false;
  }

  /// Counts a change of contact mode, and lists it if `listed`.
  void add(const ModeSwitch& change, bool listed) {
    if (change.from == contact::Mode::open) ++hits;
    if (listed) switches.push_back(change);
  }
};

/// Advances a run by exactly one revolution and fills the report. After an outcome other than ok the run is
/// over, and the report holds the completed part of the turn: samples, switches and effort.
using Cursor = std::function<Outcome(const TurnRequest&, TurnReport&)>;

/// A run that can be restarted: `restart` puts it at the start of revolution 0 of its scene with another
/// section (as TurnReport::section), without memory of earlier turns.
struct Run {
  Cursor advance;
  std::function<void(std::span<const double>)> restart;
};

}  // namespace rubsweep::integrate::run
