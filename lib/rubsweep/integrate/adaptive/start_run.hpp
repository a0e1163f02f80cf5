#pragma once

#include <Eigen/Core>
#include <memory>

#include "rubsweep/integrate/adaptive/adaptive_run.hpp"

namespace rubsweep::integrate::adaptive {

/// A cursor that owns an AdaptiveRun of `Method` over N coordinates.
template <class StepMethod, int N>
run::Cursor start_run(const scene::Scene& scene, const run::SolverOptions& options) {
  const auto start = [&]<bool Smoothed>() -> run::Cursor {
    auto run = std::make_shared<AdaptiveRun<StepMethod, N, Smoothed>>(scene, options);
    return [run](const run::TurnRequest& request, run::TurnReport& report) {
      return run->advance(request, report);
    };
  };
  return options.contact == run::ContactHandling::smoothed ? start.template operator()<true>()
                                                           : start.template operator()<false>();
}

}  // namespace rubsweep::integrate::adaptive
