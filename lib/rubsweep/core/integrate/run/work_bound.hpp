#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::integrate::run {

// Work is counted in evaluations of the right-hand side, about 0.1 microseconds each for a rotor with one
// casing. A count and not a time, so that a run ends at the same place on every host.

/// Work of a step of closed forms, and of an expansion into a Taylor series, in evaluations of about the same
/// time; that of a tangent vector is a share of the motion's.
inline constexpr double work_of_a_step = 2, work_of_an_expansion = 50, share_of_a_tangent = 1.0 / 3;

/// Work of a run since its start.
inline double work(const Effort& effort) {
  const long other_steps = effort.steps + effort.refused - effort.taylor_pieces;
  return static_cast<double>(effort.rhs_calls) + work_of_a_step * static_cast<double>(other_steps) +
         work_of_an_expansion * effort.taylor_work;
}

/// Largest number of evaluations of an adaptive turn, for its steps and the searches for events inside them:
/// those of as many steps by dopri5 as a turn may take, and a third more.
inline long most_evaluations_of_a_turn(const SolverOptions& options) {
  return 8 * options.max_steps_per_revolution;
}

/// Largest number of Taylor pieces of a turn: as much work, but never fewer than the smallest limit of
/// steps.
inline long most_pieces_of_a_turn(const SolverOptions& options) {
  return std::min(options.max_steps_per_revolution,
                  std::max(SolverOptions::max_steps_low, options.max_steps_per_revolution / 10));
}

/// Work of a whole run, whatever the solver: that of ten of the dearest turns. A smaller limit of a turn does
/// not shorten runs whose turns are cheap. With more than four coordinates, those of a rotor with one casing,
/// each evaluation takes longer, in proportion, and there are fewer.
inline double most_work_of_a_run(const SolverOptions& options, Eigen::Index coordinates) {
  constexpr double usual_coordinates = 4;
  const long steps = std::max(options.max_steps_per_revolution, SolverOptions{}.max_steps_per_revolution);
  return 100 * static_cast<double>(steps) *
         std::min(1.0, usual_coordinates / static_cast<double>(coordinates));
}

/// Budget of work that several share. Counts down by `spend`, and stays used up.
class WorkBudget {
 public:
  explicit WorkBudget(double work) : left_(work) {}
  void spend(double work) { left_ -= work; }
  double left() const { return left_; }
  bool used_up() const { return left_ <= 0; }

 private:
  double left_;
};

}  // namespace rubsweep::integrate::run
