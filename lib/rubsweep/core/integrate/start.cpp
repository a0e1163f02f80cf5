#include "rubsweep/core/integrate/start.hpp"

#include <algorithm>
#include <memory>
#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/flight_run.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/numerics/flush_subnormals.hpp"

namespace rubsweep::integrate {
namespace {

struct Restarting {
  scene::Scene scene;
  run::SolverOptions options;
  run::Cursor cursor;
};

run::Run start_restarting(const scene::Scene& scene, const run::SolverOptions& options) {
  auto run =
      std::make_shared<Restarting>(Restarting{scene, options, adaptive::start_adaptive(scene, options)});
  return {[run](const run::TurnRequest& request, run::TurnReport& report) {
            const numerics::FlushSubnormals flush;
            return run->cursor(request, report);
          },
          [run](std::span<const double> section) {
            run::set_initial_state(run->scene, section);
            run->cursor = adaptive::start_adaptive(run->scene, run->options);
          }};
}

}  // namespace

Solver solver_of(const scene::Scene& scene, const run::SolverOptions& options) {
  // Only the steppers support torsion.
  if (scene.twist || options.method == run::Method::adaptive) return Solver::adaptive;
  if (options.method == run::Method::exact) return Solver::exact;
  return options.contact == run::ContactHandling::located && exact::modes::exact_applies(scene)
             ? Solver::exact
             : Solver::adaptive;
}

run::Run start(const scene::Scene& scene, const run::SolverOptions& options, exact::modes::ModeCache& modes) {
  const bool curved = std::ranges::any_of(scene.contacts, [](const auto& c) { return c.law != nullptr; });
  if (curved && !run::knows_curved_laws(options)) throw ConfigError(std::string(run::no_curved_laws));
  if (may_fly(scene, options)) return start_flights(scene, options, modes);
  return solver_of(scene, options) == Solver::exact ? start_hybrid(scene, options, modes)
                                                    : start_restarting(scene, options);
}

}  // namespace rubsweep::integrate
