#pragma once

#include <Eigen/Core>
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

}  // namespace rubsweep::branch::orbits
