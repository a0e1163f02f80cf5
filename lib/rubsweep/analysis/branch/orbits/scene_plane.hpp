#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/branch/orbits/plane_orbits.hpp"
#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

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
