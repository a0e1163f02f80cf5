#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// A place in the plane of two parameters, and the shaft angle at which the turns of an orbit begin.
struct PlanePoint {
  double first = 0, second = 0;
  double phase_rad = 0;
  /// Contact that the orbits are clear of: its force is left out, so that they are smooth where they come to
  /// touch everywhere at once. Below 0: none.
  int clear_of = -1;

  bool operator==(const PlanePoint&) const = default;
};

/// The guard of one contact from one of its modes to another.
struct ArmedGuard {
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;
};

/// A guard at one state, as a scaled length, with its first two derivatives by the shaft angle.
struct GuardMotion {
  double value = 0, rate = 0, curvature = 0;
};

struct ParameterRange {
  double low = 0, high = 0;

  double width() const { return high - low; }
  bool holds(double value) const { return value >= low && value <= high; }
};

/// Orbits of a map with two parameters: as OrbitProblem, whose members mean the same here.
struct PlaneOrbits {
  std::function<Evaluation(const PlanePoint&, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy)> returns;
  /// May be left out.
  std::function<std::optional<OrbitFacts>(const PlanePoint&, const Eigen::VectorXd& state)> facts;
  /// The guard at the start of a turn; empty where it cannot be told. May be left out where no graze is
  /// followed, as may `at_phase`.
  std::function<std::optional<GuardMotion>(const PlanePoint&, const Eigen::VectorXd& state,
                                           const ArmedGuard&)>
      guard;
  /// The state `phase_rad` >= 0 after the start of the orbit, at the sample next to it: the phase becomes
  /// that of the sample.
  std::function<std::optional<Eigen::VectorXd>(const PlanePoint&, const Eigen::VectorXd& state,
                                               double& phase_rad)>
      at_phase;
  int order = 1;
  ParameterRange first, second;
};

/// Guards of a scene without pulses, at its sections.
class SectionGuards {
 public:
  explicit SectionGuards(const scene::Scene& scene);
  SectionGuards(const SectionGuards&) = delete;
  SectionGuards& operator=(const SectionGuards&) = delete;

  /// The guard at phase 0 and at `section` (2n scaled numbers), its contact in the mode `from` of the guard,
  /// the others in those that the state has by itself. Empty where no such guard is armed in that mode.
  std::optional<GuardMotion> at(std::span<const double> section, const ArmedGuard& guard);

 private:
  using State = std::vector<double>;

  std::optional<contact::Guard> guard_at(const State& state, double phase_rad, const ArmedGuard& guard) const;
  void enter_modes(const State& state, const ArmedGuard& guard);

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  integrate::law::Dynamics<Eigen::Dynamic, false> dynamics_;
};

/// The scene with its time counted from an instant at which its shaft has turned by `phase_rad`. Its pulses
/// stay where they are.
scene::Scene begun_at_phase(scene::Scene scene, double phase_rad);

/// The scene at each place of a plane of two parameters; empty where there is none.
using ScenePlane = std::function<std::optional<scene::Scene>(double first, double second)>;

/// Orbits of `order` turns of a plane of scenes, as scene_orbits() has them along a line. Ranges are left to
/// the caller.
PlaneOrbits scene_plane_orbits(ScenePlane plane, int order, const integrate::run::SolverOptions& solver,
                               integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
