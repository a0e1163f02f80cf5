#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::integrate::run {

// Work is counted in evaluations of the right-hand side, each about 0.1 microseconds for a rotor with one
// casing. A count instead of a time makes a run end at the same place on every computer.

/// Work of a step with closed forms and of a Taylor expansion, as the number of evaluations that take about
/// the same time. The work for a tangent vector is given as a share of the work for the motion.
inline constexpr double work_of_a_step = 2, work_of_an_expansion = 50, share_of_a_tangent = 1.0 / 3;

/// Work of a run since its start.
inline double work(const Effort& effort) {
  const long other_steps = effort.steps + effort.refused - effort.taylor_pieces;
  return static_cast<double>(effort.rhs_calls) + work_of_a_step * static_cast<double>(other_steps) +
         work_of_an_expansion * effort.taylor_work;
}

/// Largest number of evaluations in an adaptive turn, for its steps and for event searches inside them: that
/// of the largest allowed number of dopri5 steps, plus a third.
inline long most_evaluations_of_a_turn(const SolverOptions& options) {
  return 8 * options.max_steps_per_revolution;
}

/// Largest number of Taylor pieces in a turn: the same work, but never fewer than the smallest limit of
/// steps.
inline long most_pieces_of_a_turn(const SolverOptions& options) {
  return std::min(options.max_steps_per_revolution,
                  std::max(SolverOptions::max_steps_low, options.max_steps_per_revolution / 10));
}

/// Largest work of a whole run with any solver: about ten of the most expensive turns. If the limit of steps
/// is set below the default, runs of cheap turns do not become shorter. With more than four coordinates (a
/// rotor with one casing) each evaluation takes longer, and the number is reduced in proportion.
inline double most_work_of_a_run(const SolverOptions& options, Eigen::Index coordinates) {
  constexpr double usual_coordinates = 4;
  const long steps = std::max(options.max_steps_per_revolution, SolverOptions{}.max_steps_per_revolution);
  return 100 * static_cast<double>(steps) *
         std::min(1.0, usual_coordinates / static_cast<double>(coordinates));
}

/// Budget of work for several users. `spend` reduces it; a budget that is used up stays used up.
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
