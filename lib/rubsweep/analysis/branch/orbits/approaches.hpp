#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// Finds contacts that have a constant penetration, or that never separate, among the states of an orbit.
class EvenContacts {
 public:
  explicit EvenContacts(const scene::Scene& scene);

  /// Adds states: columns of 2n scaled numbers in the fixed or in the rotating frame.
  void add(const Eigen::Ref<const Eigen::MatrixXd>& states);

  /// Stores the even contacts over all added states, and the contacts that touch along the whole orbit. Mode
  /// changes of even contacts are removed, since within rounding of zero the modes of a solver are arbitrary.
  /// The sign of the penetration decides whether such a contact touches.
  void settle(OrbitFacts& facts) const;

 private:
  std::vector<EvenContact> list() const;

  struct Range {
    double least, largest;
  };

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  std::vector<Range> ranges_;
};

/// Scaled penetration of one contact at one state; < 0: gap.
double penetration_at(const scene::Scene& scene, const Eigen::VectorXd& state, int contact);

/// States of an orbit at equal steps of the phase, the first at phase 0: columns of 2n scaled numbers in the
/// fixed frame.
struct SampledOrbit {
  Eigen::MatrixXd states;
  double step_rad = 0;
  bool closes = true;  ///< true: the first state follows the last one by one step
};

/// Approaches of an orbit: places where a guard comes nearest to zero and turns back. In flight this is the
/// smallest gap between two hits, in contact the smallest penetration, and likewise for every guard that is
/// armed in a mode (contact::guards_of). `switches`: all changes of contact mode of the orbit, by phase.
/// Extremes are those of the cubic through guard and rate at two neighbouring samples without a change of
/// mode between them. Empty for a scene with torsion.
std::vector<Approach> approaches_of(const scene::Scene& scene, const SampledOrbit& orbit,
                                    std::span<const integrate::run::ModeSwitch> switches);

}  // namespace rubsweep::branch::orbits
