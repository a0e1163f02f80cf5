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

/// Point in the plane of two parameters, and shaft angle at which the turns of an orbit begin.
struct PlanePoint {
  double first = 0, second = 0;
  double phase_rad = 0;
  /// Contact whose force is omitted, so that the map stays smooth where an orbit begins to touch this contact
  /// at all its points at once. < 0: none.
  int clear_of = -1;

  bool operator==(const PlanePoint&) const = default;
};

/// Guard of one contact for a change from one of its modes to another.
struct ArmedGuard {
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;
};

/// Value of a guard at one state, as a scaled length, with its first two derivatives by the shaft angle.
struct GuardMotion {
  double value = 0, rate = 0, curvature = 0;
};

struct ParameterRange {
  double low = 0, high = 0;

  double width() const { return high - low; }
  bool holds(double value) const { return value >= low && value <= high; }
};

/// Orbits of a map with two parameters. Members mean the same as in OrbitProblem.
struct PlaneOrbits {
  std::function<Evaluation(const PlanePoint&, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy)> returns;
  /// Facts of an orbit; this member may be empty.
  std::function<std::optional<OrbitFacts>(const PlanePoint&, const Eigen::VectorXd& state)> facts;
  /// Guard at the start of a turn; empty where it cannot be computed. `guard` and `at_phase` may be empty
  /// where no graze is followed.
  std::function<std::optional<GuardMotion>(const PlanePoint&, const Eigen::VectorXd& state,
                                           const ArmedGuard&)>
      guard;
  /// State at the sample nearest to `phase_rad` >= 0 after the start of the orbit. The argument becomes the
  /// phase of that sample.
  std::function<std::optional<Eigen::VectorXd>(const PlanePoint&, const Eigen::VectorXd& state,
                                               double& phase_rad)>
      at_phase;
  int order = 1;
  ParameterRange first, second;
};

/// Evaluates guards of a scene without pulses at its sections.
class SectionGuards {
 public:
  explicit SectionGuards(const scene::Scene& scene);
  SectionGuards(const SectionGuards&) = delete;
  SectionGuards& operator=(const SectionGuards&) = delete;

  /// Guard at phase 0 and state `section` (2n scaled numbers). The contact of `guard` is in the mode
  /// guard.from, the others in the modes that follow from the state. Empty where the mode guard.from has no
  /// such guard.
  std::optional<GuardMotion> at(std::span<const double> section, const ArmedGuard& guard);

 private:
  using State = std::vector<double>;

  std::optional<contact::Guard> guard_at(const State& state, double phase_rad, const ArmedGuard& guard) const;
  void enter_modes(const State& state, const ArmedGuard& guard);

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  integrate::law::Dynamics<Eigen::Dynamic, false> dynamics_;
};

/// Scene with its time shifted so that time 0 is when its shaft has turned by `phase_rad`. Its pulses are not
/// shifted.
scene::Scene begun_at_phase(scene::Scene scene, double phase_rad);

/// Scene at each point of a plane of two parameters; empty where it does not exist.
using ScenePlane = std::function<std::optional<scene::Scene>(double first, double second)>;

/// Orbits of `order` turns over a plane of scenes, in the same form as scene_orbits() for one parameter. The
/// caller sets the ranges.
PlaneOrbits scene_plane_orbits(ScenePlane plane, int order, const integrate::run::SolverOptions& solver,
                               integrate::exact::modes::ModeCache& modes);

}  // namespace rubsweep::branch::orbits
