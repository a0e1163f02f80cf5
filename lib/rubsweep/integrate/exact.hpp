#pragma once

#include <memory>
#include <tuple>

#include "rubsweep/integrate/exact_plan.hpp"
#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate {

/// The last exact plans made, so that runs of one machine at other speeds and unbalances need not factorise
/// again. Belongs to one thread.
class ExactPlans {
 public:
  template <int N>
  std::shared_ptr<ExactPlan<N>> plan_for(const scene::Scene& scene) {
    auto& last = std::get<std::shared_ptr<ExactPlan<N>>>(last_);
    if (!last || !last->fits(scene)) last = std::make_shared<ExactPlan<N>>(scene);
    return last;
  }

 private:
  std::tuple<std::shared_ptr<ExactPlan<2>>, std::shared_ptr<ExactPlan<4>>, std::shared_ptr<ExactPlan<6>>,
             std::shared_ptr<ExactPlan<Eigen::Dynamic>>>
      last_;
};

/// Starts a run of `scene` by the exact solver: closed forms between mode switches, found by certified steps.
/// A turn that has no closed form (an annular stop touched, friction not saturated, an undamped resonance) is
/// made of Taylor pieces and counted in Effort::taylor_turns; with a stepper that `options` name, or where
/// friction is stiff, by that stepper and counted in Effort::adaptive_turns. The run returns to closed forms as
/// soon as the rotor has been free for a turn, or after a while.
Run start_exact(const scene::Scene& scene, const SolverOptions& options, ExactPlans& plans);

/// Whether some turn of the scene may have a closed form: not more stops than a plan can number, nor more
/// coordinates than it holds (all that a configuration can ask for).
bool exact_applies(const scene::Scene& scene);

}  // namespace rubsweep::integrate
