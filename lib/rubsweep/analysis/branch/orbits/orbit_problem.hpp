#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::branch::orbits {

/// Outcome of one evaluation of an orbit's map.
enum class Evaluation {
  ok,
  infeasible,  ///< there is no such machine or scene at this parameter
  failed,      ///< the solver could not make a turn
};

/// A contact whose penetration is the same all along an orbit, so that the orbit comes to touch everywhere at
/// once: a circle in a ring about its centre, or a rotor at rest beside a wall.
struct EvenContact {
  int contact = 0;
  double penetration = 0;  ///< penetration in the middle of its range, scaled; below 0 the gap
  double spread = 0;       ///< width of that range, from rounding or from a ring just off the centre
  contact::Mode touching = contact::Mode::sprung;  ///< mode that it comes to from the open one
};

/// Facts of an orbit over its period.
struct OrbitFacts {
  double period_turns = 0;      ///< turns of the shaft
  int hits = 0;                 ///< number of hits over the whole period
  double contact_fraction = 0;  ///< share of the period
  double amplitude_m = 0;       ///< largest distance of the rotor from its mean position
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;
  bool touched = false;
  /// Every force that acted along the whole trajectory follows the law: no slip reversed that a friction with
  /// a fixed direction says cannot.
  bool feasible = true;
  /// In the order of time; phases count from the start of the orbit.
  std::vector<integrate::run::ModeSwitch> switches;
  /// States where the turns of the period begin; of an oval of one loop its own and, where there is one, that
  /// half a period on.
  std::vector<Eigen::VectorXd> sections;
  std::vector<EvenContact> even;  ///< their changes of mode are not among the switches
  std::vector<int> unbroken;      ///< contacts that touch all along, by ascending numbers
};

/// Where a guard of a contact comes nearest to what it guards, without reaching it.
struct Approach {
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;  ///< the change that does not happen
  double phase_rad = 0;                                                ///< phase as that of a switch
  double distance = 0;  ///< >= 0, in the unit of the guard; smooth along a branch, and zero at the graze
};

/// Changes of contact mode on an orbit, and those that nearly happen.
struct ContactPassages {
  std::vector<integrate::run::ModeSwitch> switches;
  std::vector<Approach> approaches;
};

/// Replaces `state` by its image at `parameter` and, where given (not null), `monodromy` by the derivative of
/// the image by the state.
using OrbitMap =
    std::function<Evaluation(double parameter, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy)>;

/// Orbits of a map that depends on a parameter: fixed points of `returns`, the map over the whole period.
struct OrbitProblem {
  OrbitMap returns;
  OrbitMap
      half_returns;  ///< the same over half the period, where that is a whole number of turns, or of an oval
  /// Facts of the orbit from `state`; empty where it cannot be followed. May be left out, and then nothing is
  /// known of contacts, nor of shorter periods.
  std::function<std::optional<OrbitFacts>(double parameter, const Eigen::VectorXd& state)> facts;
  /// Changes and approaches at its contacts. Without these a hit that comes and goes between two orbits is
  /// not looked for.
  std::function<std::optional<ContactPassages>(double parameter, const Eigen::VectorXd& state)> passages;
  /// Penetration of a contact at a state, as that of EvenContact. Without it grazes of even contacts are not
  /// looked for.
  std::function<double(double parameter, const Eigen::VectorXd& state, int contact)> penetration;
  int order = 1;               ///< turns of the period
  double low = 0, high = 0;    ///< range of the parameter that is looked at
  double parameter_scale = 1;  ///< > 0: change of the parameter that counts as much as one unit of state
};

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
