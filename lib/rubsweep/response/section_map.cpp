#include "rubsweep/response/section_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/error.hpp"
#include "rubsweep/integrate/adaptive.hpp"

namespace rubsweep::response {

SceneMap::SceneMap(const scene::Scene& scene, const integrate::SolverOptions& solver)
    : scene_(scene), solver_(solver) {
  scene_.pulse.reset();
}

bool SceneMap::operator()(std::span<double> section) {
  const Eigen::Index n = scene_.structure.coordinates();
  if (section.size() != 2 * static_cast<std::size_t>(n)) {
    throw SolverError(
        fmt::format("a section of {} coordinates has {} numbers, got {}", n, 2 * n, section.size()));
  }
  const Eigen::Map<const Eigen::VectorXd> state(section.data(), 2 * n);
  scene_.displacement_m = scene_.length_scale_m * state.head(n);
  scene_.velocity_m_per_s = scene_.length_scale_m * scene_.speed_rad_per_s * state.tail(n);
  if (integrate::start_adaptive(scene_, solver_)(turn_) != integrate::Outcome::ok) return false;
  std::ranges::copy(turn_.section, section.begin());
  return true;
}

}  // namespace rubsweep::response
