#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "rubsweep/integrate/mode_plan.hpp"

namespace rubsweep::integrate {

/// Everything about a structure and its stops that no speed, unbalance or kick changes: the exact flows of
/// its contact modes, with friction saturated. Modes are made when first met; one thread uses a plan at a
/// time.
template <int N>
class ExactPlan {
 public:
  explicit ExactPlan(const scene::Scene& scene);

  /// Whether this plan was made for the same structure, stops and constant forces.
  bool fits(const scene::Scene& scene) const;

  /// Plan of a joint mode, numbered mode of contact i times 4^i. Null where the mode has no equilibrium, as
  /// in a structure without springs.
  const ModePlan<N>* mode(std::size_t joint);

  /// Scaled with time in seconds.
  const ScaledSystem<Eigen::Dynamic>& system() const { return system_; }
  const Eigen::MatrixXd& inverse_mass() const { return inverse_mass_; }
  const std::vector<contact::SaturatedFriction>& friction() const { return friction_; }

 private:
  scene::Scene scene_;
  ScaledSystem<Eigen::Dynamic> system_;
  Eigen::MatrixXd inverse_mass_;
  std::vector<contact::SaturatedFriction> friction_;
  std::vector<std::unique_ptr<ModePlan<N>>> modes_;
  std::vector<bool> made_;
  std::size_t count_ = 0;
};

/// Stops whose joint modes a plan can number.
inline constexpr std::size_t most_exact_contacts = 6;

extern template class ExactPlan<2>;
extern template class ExactPlan<4>;
extern template class ExactPlan<6>;
extern template class ExactPlan<Eigen::Dynamic>;

}  // namespace rubsweep::integrate
