#include "rubsweep/core/integrate/adaptive/start_twisted.hpp"

#include <memory>

#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/adaptive/twist_dynamics.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

template <bool Smoothed>
run::Cursor start(const scene::Scene& scene, const run::SolverOptions& options) {
  auto run = std::make_shared<AdaptiveRun<TwistDynamics<Smoothed>>>(without_turning(scene), options,
                                                                    twist_law(scene));
  return [run](const run::TurnRequest& request, run::TurnReport& report) {
    return run->advance(request, report);
  };
}

}  // namespace

run::Cursor start_twisted(const scene::Scene& scene, const run::SolverOptions& options) {
  return options.contact == run::ContactHandling::smoothed ? start<true>(scene, options)
                                                           : start<false>(scene, options);
}

}  // namespace rubsweep::integrate::adaptive
