#include <vector>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/adaptive/start_run.hpp"

namespace rubsweep::integrate::adaptive::detail {

run::Cursor start_rosenbrock4(const scene::Scene& scene, const run::SolverOptions& options) {
  return start_run<Rosenbrock4, Eigen::Dynamic>(scene, options);
}

}  // namespace rubsweep::integrate::adaptive::detail
