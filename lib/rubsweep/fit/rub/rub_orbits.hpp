#pragma once

#include <Eigen/Core>
#include <mutex>
#include <optional>
#include <vector>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/response/motion/options.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::fit::rub {

/// Lines of a rub that are asked for.
struct AskedLines {
  double speed_hz = 0;
  double eccentricity_m = 0;
  int turns = 1;              ///< after which the motion repeats
  std::vector<double> order;  ///< multiples of 1 / turns, negative for backward whirl
};

/// Rubs that repeat after whole turns, of one machine after the other whose numbers differ little. The first
/// one settles from its kick; from then on the orbit of the last machine is corrected by Newton's iteration
/// on the section, with the derivatives that the solver has, so that lines are smooth in the numbers of the
/// machine. For several threads.
class RubOrbits {
 public:
  RubOrbits(integrate::run::SolverOptions solver, response::motion::ResponseOptions options);

  /// A of A e^{i order phi}, in metres, of the displacement x + iy at the observed point, phi = 0 where the
  /// mark of the shaft points along +x. Hertz' contacts have the secants of the configuration. Throws
  /// ConfigError where the machine settles on another motion than one in contact that repeats after so many
  /// turns.
  Eigen::VectorXcd lines_m(const scene::PreparedMachine& machine, const AskedLines& asked);

 private:
  std::optional<Eigen::VectorXd> last_m() const;

  integrate::run::SolverOptions solver_;
  response::motion::ResponseOptions options_;
  mutable std::mutex mutex_;
  std::optional<Eigen::VectorXd> last_m_;  ///< section of the last orbit, times its length scale
};

}  // namespace rubsweep::fit::rub
