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
  infeasible,  ///< no machine or scene exists at this parameter
  failed,      ///< the solver could not make a turn
};

/// Contact whose penetration is constant along an orbit, so that the orbit grazes at all its points at once.
/// Examples: a circle in an annular stop around its centre, or a rotor at rest next to a wall.
struct EvenContact {
  int contact = 0;
  double penetration = 0;  ///< middle of the penetration's range, scaled; < 0: gap
  double spread = 0;       ///< width of the penetration's range, from rounding or a slightly eccentric stop
  contact::Mode touching = contact::Mode::sprung;  ///< mode after the open mode, when contact begins
};

/// Facts of an orbit over its period.
struct OrbitFacts {
  double period_turns = 0;      ///< turns of the shaft
  int hits = 0;                 ///< number of hits over the whole period
  double contact_fraction = 0;  ///< share of the period with contact
  double amplitude_m = 0;       ///< largest distance of the rotor from its mean position
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;
  bool touched = false;
  /// Whether every force along the orbit follows its law. False where a slip reversed, although the friction
  /// law assumes a fixed direction.
  bool feasible = true;
  /// Changes of mode in the order of time; phases are measured from the start of the orbit.
  std::vector<integrate::run::ModeSwitch> switches;
  /// States at the begin of each turn of the period. For an oval of one loop: its own state and, where it
  /// exists, the state half a period later.
  std::vector<Eigen::VectorXd> sections;
  std::vector<EvenContact> even;  ///< even contacts; their changes of mode are not in switches
  std::vector<int> unbroken;      ///< numbers of contacts that touch along the whole orbit, ascending
};

/// Place where a guard of a contact comes nearest to zero and turns back before zero.
struct Approach {
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;  ///< change that does not happen
  double phase_rad = 0;                                                ///< phase, as in a switch
  double distance = 0;  ///< >= 0, in the unit of the guard; smooth along a branch, zero at the graze
};

/// Changes of contact mode on an orbit, and those that almost happen.
struct ContactPassages {
  std::vector<integrate::run::ModeSwitch> switches;
  std::vector<Approach> approaches;
};

/// Replaces `state` by its image at `parameter`. If `monodromy` is not null, sets it to the derivative of the
/// image by the state.
using OrbitMap =
    std::function<Evaluation(double parameter, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy)>;

/// Periodic orbits of a map with a parameter: fixed points of `returns`, the map over the whole period.
struct OrbitProblem {
  OrbitMap returns;
  OrbitMap
      half_returns;  ///< map over half the period; only for an even number of whole turns, or for an oval
  /// Facts of the orbit from `state`; empty where it cannot be followed. This member may be empty; contacts
  /// and shorter periods are then unknown.
  std::function<std::optional<OrbitFacts>(double parameter, const Eigen::VectorXd& state)> facts;
  /// Changes and approaches at the contacts of an orbit. If this member is empty, a hit that appears and
  /// disappears again within one step is not found.
  std::function<std::optional<ContactPassages>(double parameter, const Eigen::VectorXd& state)> passages;
  /// Penetration of a contact at a state, as in EvenContact. If this member is empty, grazes of even contacts
  /// are not sought.
  std::function<double(double parameter, const Eigen::VectorXd& state, int contact)> penetration;
  int order = 1;             ///< turns of the period
  double low = 0, high = 0;  ///< range of the parameter in which orbits are followed
  /// > 0: change of the parameter that counts as much as a change of the state by 1
  double parameter_scale = 1;
};

/// Largest relative tolerance of a stepper that follows an orbit. The other constant is the number of samples
/// in a turn.
inline constexpr double tolerance_of_orbits = 1e-11;
inline constexpr int samples_per_turn = 128;

/// Problem of closed orbits over `order` turns, and over half of these turns if `order` is even. `Orbits` has
/// advance(turns, parameter, state, monodromy), with arguments as in OrbitMap, and facts(parameter, state)
/// and passages(parameter, state).
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
