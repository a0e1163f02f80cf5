#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {

/// Looks through states of an orbit for contacts whose penetration stays as it is, or that never part.
class EvenContacts {
 public:
  explicit EvenContacts(const scene::Scene& scene);

  /// `states`: columns of 2n scaled numbers in the fixed or in the turning frame.
  void add(const Eigen::Ref<const Eigen::MatrixXd>& states);

  /// Fills in the even contacts over all states added, and those that touch all along. Takes the changes of
  /// mode of even contacts out, and has them touch by the sign of their penetration: where it is within
  /// rounding of zero all along, the modes that a solver meets are chance.
  void settle(OrbitFacts& facts) const;

 private:
  std::vector<EvenContact> list() const;

  struct Range {
    double least, largest;
  };

  integrate::run::ScaledSystem<Eigen::Dynamic> system_;
  std::vector<Range> ranges_;
};

/// The penetration of one contact at one state, scaled; below 0 the gap.
double penetration_at(const scene::Scene& scene, const Eigen::VectorXd& state, int contact);

/// States of an orbit at equal steps of the phase: columns of 2n scaled numbers, in the fixed frame, the
/// first one at the phase 0.
struct SampledOrbit {
  Eigen::MatrixXd states;
  double step_rad = 0;
  bool closes = true;  ///< true: one step behind the last state comes the first one
};

/// Where guards come nearest to what they guard and turn back: in flight the smallest gap between two hits,
/// in contact the smallest penetration, and so on for every guard that a mode has armed (contact::guards_of).
/// `switches`: all changes of contact mode of the orbit, by phase. Maxima are those of cubics through the
/// guard and its rate at two neighbouring samples between which the contact does not change its mode. Of a
/// scene with torsion none.
std::vector<Approach> approaches_of(const scene::Scene& scene, const SampledOrbit& orbit,
                                    std::span<const integrate::run::ModeSwitch> switches);

}  // namespace rubsweep::branch::orbits
