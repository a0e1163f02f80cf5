#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/integrate/run/scaled_system.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::trace {

/// Friction of the contacts whose friction is dry, at one instant of a run. A contact that slips has mu S;
/// the holding friction of one that sticks is no function of its own motion: it is the force that keeps the
/// slip zero against all that acts on the structure at that instant, within mu S.
class DryForces {
 public:
  explicit DryForces(const scene::Scene& scene);

  /// Whether some contact has dry friction. Without one nobody has to ask.
  bool any() const { return any_; }

  /// Newtons along the tangent on the casing, one number per contact, 0 where it is open or its friction is
  /// of another kind. `scaled`: a state as integrate::run::TurnReport holds it; `turns`: of the shaft since t
  /// = 0.
  std::vector<double> forces_n(const scene::Scene& scene, std::span<const double> scaled, double turns) const;

 private:
  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  bool any_ = false;
};

}  // namespace rubsweep::trace
