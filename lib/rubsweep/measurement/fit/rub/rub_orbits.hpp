#pragma once

#include <Eigen/Core>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/response/motion/options.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::fit::rub {

/// Spectral lines of a rub that a caller requests.
struct AskedLines {
  double speed_hz = 0;
  double eccentricity_m = 0;
  int turns = 1;              ///< period of the motion in turns
  std::vector<double> order;  ///< multiples of 1 / turns, negative for backward whirl
};

/// Periodic rubs of machines with slightly different parameters. The first rub settles from its kick. Once a
/// rub of the same speed and period was followed, its orbit is corrected by Newton's method on the section,
/// with the solver's derivatives, so that the lines are smooth in the parameters. The lines depend on the
/// followed machines alone, not on other calls, their order or their threads.
class RubOrbits {
 public:
  RubOrbits(integrate::run::SolverOptions solver, response::motion::ResponseOptions options);

  /// Lines A of A e^{i order phi}, in metres, of the displacement x + iy at the observed point; phi = 0 where
  /// the mark of the shaft points along +x. Hertzian contacts use the secants of the configuration. Throws
  /// ConfigError where the machine does not settle on a motion in contact that repeats after exactly `turns`
  /// turns.
  Eigen::VectorXcd lines_m(const scene::PreparedMachine& machine, const AskedLines& asked) const;

  /// Makes the orbit of this machine the starting point for later orbits of the same speed and period. Throws
  /// like lines_m.
  void follow(const scene::PreparedMachine& machine, const AskedLines& asked);

 private:
  /// Section (in metres), samples, and the shaft angle at the first sample.
  struct Orbit;
  using SpeedAndTurns = std::pair<double, int>;

  Orbit orbit_of(const scene::PreparedMachine& machine, const AskedLines& asked) const;
  std::optional<Eigen::VectorXd> followed_m(const AskedLines& asked) const;

  integrate::run::SolverOptions solver_;
  response::motion::ResponseOptions options_;
  mutable std::mutex mutex_;
  std::map<SpeedAndTurns, Eigen::VectorXd> followed_m_;  ///< sections times the length scale
};

}  // namespace rubsweep::fit::rub
