#include <vector>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/start_run.hpp"

namespace rubsweep::integrate::detail {

Cursor start_rosenbrock4(const scene::Scene& scene, const SolverOptions& options) {
  return start_run<Rosenbrock4, Eigen::Dynamic>(scene, options);
}

}  // namespace rubsweep::integrate::detail
