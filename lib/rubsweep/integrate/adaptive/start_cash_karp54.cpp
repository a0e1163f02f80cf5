#include <vector>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/adaptive/start_run.hpp"

namespace rubsweep::integrate::adaptive::detail {

run::Cursor start_cash_karp54(const scene::Scene& scene, const run::SolverOptions& options) {
  return start_run<ReStepping<odeint::runge_kutta_cash_karp54<std::vector<double>>>, Eigen::Dynamic>(scene,
                                                                                                     options);
}

}  // namespace rubsweep::integrate::adaptive::detail
