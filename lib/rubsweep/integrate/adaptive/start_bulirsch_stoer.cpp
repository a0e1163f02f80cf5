#include <vector>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/adaptive/start_run.hpp"

namespace rubsweep::integrate::adaptive::detail {

run::Cursor start_bulirsch_stoer(const scene::Scene& scene, const run::SolverOptions& options) {
  return start_run<BulirschStoer<std::vector<double>>, Eigen::Dynamic>(scene, options);
}

}  // namespace rubsweep::integrate::adaptive::detail
