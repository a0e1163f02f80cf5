#include <vector>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/start_run.hpp"

namespace rubsweep::integrate::detail {

Cursor start_cash_karp54(const scene::Scene& scene, const SolverOptions& options) {
  return start_run<ReStepping<odeint::runge_kutta_cash_karp54<std::vector<double>>>, Eigen::Dynamic>(scene,
                                                                                                     options);
}

}  // namespace rubsweep::integrate::detail
