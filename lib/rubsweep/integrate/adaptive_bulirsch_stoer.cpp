#include <vector>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/start_run.hpp"

namespace rubsweep::integrate::detail {

Cursor start_bulirsch_stoer(const scene::Scene& scene, const SolverOptions& options) {
  return start_run<BulirschStoer<std::vector<double>>, Eigen::Dynamic>(scene, options);
}

}  // namespace rubsweep::integrate::detail
