#pragma once

#include <memory>
#include <utility>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"

namespace rubsweep::branch::orbits {

/// Largest relative tolerance of a stepper that follows an orbit, and samples of it in a turn.
inline constexpr double tolerance_of_orbits = 1e-11;
inline constexpr int samples_per_turn = 128;

/// The problem of closed orbits that `orbits` makes turn by turn, over `order` turns and, where that is even,
/// over half of them. `Orbits` has advance(turns, parameter, state, monodromy), whose last three are those of
/// an OrbitMap, facts(parameter, state) and passages(parameter, state).
template <class Orbits>
OrbitProblem problem_of_whole_turns(const std::shared_ptr<Orbits>& orbits, int order) {
  const auto map_of = [&](int turns) -> OrbitMap {
    return [orbits, turns](double parameter, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy) {
      return orbits->advance(turns, parameter, state, monodromy);
    };
  };
  OrbitProblem problem;
  problem.order = order;
  problem.returns = map_of(order);
  if (order % 2 == 0) problem.half_returns = map_of(order / 2);
  problem.facts = [orbits](double parameter, const Eigen::VectorXd& state) {
    return orbits->facts(parameter, state);
  };
  problem.passages = [orbits](double parameter, const Eigen::VectorXd& state) {
    return orbits->passages(parameter, state);
  };
  return problem;
}

}  // namespace rubsweep::branch::orbits
