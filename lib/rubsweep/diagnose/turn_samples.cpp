#include "rubsweep/diagnose/turn_samples.hpp"

#include <Eigen/Core>
#include <cstddef>

namespace rubsweep::diagnose {

void add_samples(const scene::Scene& scene, const integrate::run::TurnReport& turn,
                 std::vector<std::complex<double>>& displacement_m) {
  const auto& map = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  const auto coordinates = static_cast<std::size_t>(scene.structure.coordinates());
  for (std::size_t k = 0; k < static_cast<std::size_t>(turn.sample_count); ++k) {
    const Eigen::Map<const Eigen::VectorXd> q(turn.samples.data() + k * 2 * coordinates,
                                              scene.structure.coordinates());
    const Eigen::Vector2d z = scene.length_scale_m * (map * q);
    displacement_m.emplace_back(z.x(), z.y());
  }
}

}  // namespace rubsweep::diagnose
