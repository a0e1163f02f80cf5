#include "rubsweep/integrate/adaptive/start_dopri5.hpp"

#include <array>
#include <type_traits>
#include <vector>

#include "rubsweep/integrate/adaptive/dopri5_or_rosenbrock4.hpp"
#include "rubsweep/integrate/adaptive/start_run.hpp"
#include "rubsweep/integrate/run/coordinates.hpp"

namespace rubsweep::integrate::adaptive {

run::Cursor start_dopri5(const scene::Scene& scene, const run::SolverOptions& options) {
  // With torsion any number of coordinates is made by one law.
  const Eigen::Index coordinates = scene.twist ? Eigen::Index{Eigen::Dynamic} : scene.structure.coordinates();
  return run::with_coordinates(coordinates, [&](auto n) {
    constexpr bool dynamic = n() == Eigen::Dynamic;
    using State = std::conditional_t<dynamic, std::vector<double>,
                                     std::array<double, dynamic ? 0 : static_cast<std::size_t>(2 * n())>>;
    return start_run<Dopri5OrRosenbrock4<State>, n()>(scene, options);
  });
}

}  // namespace rubsweep::integrate::adaptive
