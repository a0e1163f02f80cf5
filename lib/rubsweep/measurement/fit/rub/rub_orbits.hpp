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

/// Lines of a rub that are asked for.
struct AskedLines {
  double speed_hz = 0;
  double eccentricity_m = 0;
  int turns = 1;              ///< after which the motion repeats
  std::vector<double> order;  ///< multiples of 1 / turns, negative for backward whirl
};

/// Rubs that repeat after whole turns, of machines whose numbers differ little. One settles from its kick,
/// or, where another of its speed and period has been followed, the orbit of that one is corrected by
/// Newton's iteration on the section, with the derivatives that the solver has, so that lines are smooth in
/// the numbers of the machine. Lines depend on the machines that were followed and not on who else asked, in
/// which order or from which thread.
class RubOrbits {
 public:
  RubOrbits(integrate::run::SolverOptions solver, response::motion::ResponseOptions options);

  /// A of A e^{i order phi}, in metres, of the displacement x + iy at the observed point, phi = 0 where the
  /// mark of the shaft points along +x. Hertz' contacts have the secants of the configuration. Throws
  /// ConfigError where the machine settles on another motion than one in contact that repeats after so many
  /// turns and not sooner.
  Eigen::VectorXcd lines_m(const scene::PreparedMachine& machine, const AskedLines& asked) const;

  /// From now on orbits of this speed and period are looked for near that of this machine. Throws as lines_m.
  void follow(const scene::PreparedMachine& machine, const AskedLines& asked);

 private:
  /// Section times the length scale, samples, and the shaft's angle where they begin.
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
