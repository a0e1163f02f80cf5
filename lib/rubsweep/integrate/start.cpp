#include "rubsweep/integrate/start.hpp"

#include <memory>

#include "rubsweep/integrate/adaptive.hpp"

namespace rubsweep::integrate {
namespace {

struct Restarting {
  scene::Scene scene;
  SolverOptions options;
  Cursor cursor;
};

Run start_restarting(const scene::Scene& scene, const SolverOptions& options) {
  auto run = std::make_shared<Restarting>(Restarting{scene, options, start_adaptive(scene, options)});
  return {[run](Turn& turn) { return run->cursor(turn); },
          [run](std::span<const double> section) {
            const Eigen::Index n = run->scene.structure.coordinates();
            const Eigen::Map<const Eigen::VectorXd> state(section.data(), 2 * n);
            run->scene.displacement_m = run->scene.length_scale_m * state.head(n);
            run->scene.velocity_m_per_s =
                run->scene.length_scale_m * run->scene.speed_rad_per_s * state.tail(n);
            run->cursor = start_adaptive(run->scene, run->options);
          }};
}

}  // namespace

Solver solver_of(const scene::Scene& scene, const SolverOptions& options) {
  if (options.method == Method::adaptive) return Solver::adaptive;
  if (options.method == Method::exact) return Solver::exact;
  return options.contact == ContactHandling::located && exact_applies(scene) ? Solver::exact
                                                                             : Solver::adaptive;
}

Run start(const scene::Scene& scene, const SolverOptions& options, ExactPlans& plans) {
  return solver_of(scene, options) == Solver::exact ? start_exact(scene, options, plans)
                                                    : start_restarting(scene, options);
}

}  // namespace rubsweep::integrate
