#include <vector>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/start_run.hpp"

namespace rubsweep::integrate::detail {

Cursor start_rkf78(const scene::Scene& scene, const SolverOptions& options) {
  return start_run<ReStepping<odeint::runge_kutta_fehlberg78<std::vector<double>>>, Eigen::Dynamic>(scene,
                                                                                                    options);
}

}  // namespace rubsweep::integrate::detail
