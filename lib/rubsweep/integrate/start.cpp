#include "rubsweep/integrate/start.hpp"

#include <memory>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"

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
  return {[run](run::Turn& turn) { return run->cursor(turn); },
          [run](std::span<const double> section) {
            const Eigen::Index n = run->scene.structure.coordinates();
            const Eigen::Map<const Eigen::VectorXd> state(section.data(), 2 * n);
            run->scene.displacement_m = run->scene.length_scale_m * state.head(n);
            run->scene.velocity_m_per_s =
                run->scene.length_scale_m * run->scene.speed_rad_per_s * state.tail(n);
            run->cursor = adaptive::start_adaptive(run->scene, run->options);
          }};
}

}  // namespace

Solver solver_of(const scene::Scene& scene, const run::SolverOptions& options) {
  if (options.method == run::Method::adaptive) return Solver::adaptive;
  if (options.method == run::Method::exact) return Solver::exact;
  return options.contact == run::ContactHandling::located && exact::exact_applies(scene) ? Solver::exact
                                                                                         : Solver::adaptive;
}

run::Run start(const scene::Scene& scene, const run::SolverOptions& options, exact::ModeCache& modes) {
  return solver_of(scene, options) == Solver::exact ? start_hybrid(scene, options, modes)
                                                    : start_restarting(scene, options);
}

}  // namespace rubsweep::integrate
