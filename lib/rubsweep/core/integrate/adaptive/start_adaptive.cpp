#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"

#include <memory>

#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/adaptive/start_twisted.hpp"
#include "rubsweep/core/integrate/run/coordinates.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

template <bool Smoothed>
run::Cursor start(const scene::Scene& scene, const run::SolverOptions& options) {
  return run::with_coordinates(scene.structure.coordinates(), [&](auto n) -> run::Cursor {
    auto run = std::make_shared<AdaptiveRun<law::Dynamics<n(), Smoothed>>>(scene, options);
    return [run](const run::TurnRequest& request, run::TurnReport& report) {
      return run->advance(request, report);
    };
  });
}

}  // namespace

run::Cursor start_adaptive(const scene::Scene& scene, const run::SolverOptions& options) {
  if (scene.twist) return start_twisted(scene, options);
  return options.contact == run::ContactHandling::smoothed ? start<true>(scene, options)
                                                           : start<false>(scene, options);
}

}  // namespace rubsweep::integrate::adaptive
