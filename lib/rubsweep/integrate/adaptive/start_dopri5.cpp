#include "rubsweep/integrate/adaptive/start_dopri5.hpp"

#include <array>
#include <vector>

#include "rubsweep/integrate/adaptive/dopri5_or_rosenbrock4.hpp"
#include "rubsweep/integrate/adaptive/start_run.hpp"

namespace rubsweep::integrate::adaptive {

run::Cursor start_dopri5(const scene::Scene& scene, const run::SolverOptions& options) {
  // Rotor with no, one or two moving casings.
  switch (scene.structure.coordinates()) {
    case 2:
      return start_run<Dopri5OrRosenbrock4<std::array<double, 4>>, 2>(scene, options);
    case 4:
      return start_run<Dopri5OrRosenbrock4<std::array<double, 8>>, 4>(scene, options);
    case 6:
      return start_run<Dopri5OrRosenbrock4<std::array<double, 12>>, 6>(scene, options);
    default:
      return start_run<Dopri5OrRosenbrock4<std::vector<double>>, Eigen::Dynamic>(scene, options);
  }
}

}  // namespace rubsweep::integrate::adaptive
