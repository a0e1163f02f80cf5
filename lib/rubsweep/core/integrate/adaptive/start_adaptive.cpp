#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"

#include <memory>
#include <utility>

#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/adaptive/twist_dynamics.hpp"
#include "rubsweep/core/integrate/run/coordinates.hpp"

namespace rubsweep::integrate::adaptive {
namespace {

template <class Dynamics, class... Arguments>
run::Cursor start(Arguments&&... arguments) {
  auto run = std::make_shared<AdaptiveRun<Dynamics>>(std::forward<Arguments>(arguments)...);
  return [run](const run::TurnRequest& request, run::TurnReport& report) {
    return run->advance(request, report);
  };
}

template <bool Smoothed>
run::Cursor start(const scene::Scene& scene, const run::SolverOptions& options) {
  if (scene.twist) return start<TwistDynamics<Smoothed>>(without_turning(scene), options, twist_law(scene));
  return run::with_coordinates(scene.structure.coordinates(), [&](auto n) -> run::Cursor {
    return start<law::Dynamics<n(), Smoothed>>(scene, options);
  });
}

}  // namespace

run::Cursor start_adaptive(const scene::Scene& scene, const run::SolverOptions& options) {
  return options.contact == run::ContactHandling::smoothed ? start<true>(scene, options)
                                                           : start<false>(scene, options);
}

}  // namespace rubsweep::integrate::adaptive
