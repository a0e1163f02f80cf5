#pragma once

#include <Eigen/Core>
#include <memory>

#include "rubsweep/integrate/adaptive_run.hpp"

namespace rubsweep::integrate {

/// A cursor that owns an AdaptiveRun of `Method` over N coordinates.
template <class Method, int N>
Cursor start_run(const scene::Scene& scene, const SolverOptions& options) {
  const auto start = [&]<bool Smoothed>() -> Cursor {
    auto run = std::make_shared<AdaptiveRun<Method, N, Smoothed>>(scene, options);
    return [run](Turn& turn) { return run->advance(turn); };
  };
  return options.contact == ContactHandling::smoothed ? start.template operator()<true>()
                                                      : start.template operator()<false>();
}

}  // namespace rubsweep::integrate
