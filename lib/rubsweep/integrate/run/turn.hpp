#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/contact/contact_mode.hpp"
#include "rubsweep/integrate/run/outcome.hpp"

namespace rubsweep::integrate::run {

/// A change of contact mode, `phase_rad` into the revolution.
struct ModeSwitch {
  double phase_rad = 0;
  int contact = 0;
  contact::Mode from = contact::Mode::open;
  contact::Mode to = contact::Mode::open;
};

/// Work done since the start of the run.
struct Effort {
  long rhs_calls = 0;
  long steps = 0;    ///< accepted
  long refused = 0;  ///< refused by the error control
  long switches = 0;
  long implicit_steps = 0;  ///< accepted ones that Stepper::automatic took with rosenbrock4
  long taylor_turns = 0;    ///< revolutions without a closed form, by pieces of Taylor series
  long adaptive_turns = 0;  ///< revolutions without a closed form, by a stepper
};

/// One revolution: what is asked of the integrator, and what it answers. Reused from turn to turn.
/// States are scaled and hold 2n numbers: the displacements q in units of the scene's length scale L, then
/// the velocities q' in units of L * speed.
struct Turn {
  int samples_per_revolution = 0;  ///< asked: states at phases 2 pi k / N, k = 0..N-1; 0: none
  bool peaks = false;              ///< asked: fill the peak_ numbers
  bool switches_wanted = false;    ///< asked: fill `switches`

  std::vector<double> section;  ///< scaled state at the end of the turn, 2n
  std::vector<double> samples;  ///< samples_per_revolution x 2n, row by row
  std::vector<ModeSwitch> switches;
  /// Asked, and answered in place: 2n x m (m <= 2n; 0: none) small changes of the section at the start,
  /// which the turn takes to its end by d(section at the end) / d(section at the start). By closed forms and
  /// Taylor pieces: a turn by a stepper leaves them as they are.
  Eigen::MatrixXd tangent_vectors;
  int hits = 0;                 ///< open -> touching, all contacts together
  double contact_fraction = 0;  ///< share of the turn with at least one contact touching
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;  ///< largest normal force at any one contact
  bool touched = false;             ///< some contact was touching at some time in the turn
  bool touching_at_end = false;
  bool slip_reversed = false;  ///< a slip speed was <= 0 while touching
  Effort effort;               ///< of the whole run so far

  /// Forgets the last revolution's switches, hits, peaks and words; what is asked stays.
  void clear_answers() {
    switches.clear();
    hits = 0;
    contact_fraction = peak_displacement_m = peak_contact_force_n = 0;
    touched = touching_at_end = slip_reversed = false;
  }

  /// Counts a change of contact mode, and lists it where that is asked.
  void add(const ModeSwitch& change) {
    if (change.from == contact::Mode::open) ++hits;
    if (switches_wanted) switches.push_back(change);
  }
};

/// Advances a run by exactly one revolution and fills the turn. After an outcome other than ok the run is
/// over.
using Cursor = std::function<Outcome(Turn&)>;

/// A run that can be set back: `restart` puts it at the start of revolution 0 of its scene at another section
/// (as Turn::section), with no memory of what it did before.
struct Run {
  Cursor advance;
  std::function<void(std::span<const double>)> restart;
};

}  // namespace rubsweep::integrate::run
