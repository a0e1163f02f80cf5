#pragma once

#include <Eigen/Core>
#include <memory>

#include "rubsweep/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/integrate/adaptive/twist_dynamics.hpp"

namespace rubsweep::integrate::adaptive {

/// A cursor that owns an AdaptiveRun of `Method` over N coordinates, Eigen::Dynamic where the scene has
/// torsion.
template <class StepMethod, int N>
run::Cursor start_run(const scene::Scene& scene, const run::SolverOptions& options) {
  const auto start = [&]<bool Smoothed>() -> run::Cursor {
    if constexpr (N == Eigen::Dynamic) {
      if (scene.twist) {
        using Law = TwistDynamics<Smoothed>;
        auto run = std::make_shared<AdaptiveRun<StepMethod, N, Smoothed, Law>>(without_turning(scene),
                                                                               options, twist_law(scene));
        return [run](const run::TurnRequest& request, run::TurnReport& report) {
          return run->advance(request, report);
        };
      }
    }
    auto run = std::make_shared<AdaptiveRun<StepMethod, N, Smoothed>>(scene, options);
    return [run](const run::TurnRequest& request, run::TurnReport& report) {
      return run->advance(request, report);
    };
  };
  return options.contact == run::ContactHandling::smoothed ? start.template operator()<true>()
                                                           : start.template operator()<false>();
}

}  // namespace rubsweep::integrate::adaptive
