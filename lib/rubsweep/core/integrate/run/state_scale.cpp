#include "rubsweep/core/integrate/run/state_scale.hpp"

namespace rubsweep::integrate::run {
namespace {

using Numbers = Eigen::Map<const Eigen::VectorXd>;

Numbers numbers(std::span<const double> part) {
  return {part.data(), static_cast<Eigen::Index>(part.size())};
}

}  // namespace

std::vector<double> StateScale::state(const Eigen::VectorXd& displacement_m,
                                      const Eigen::VectorXd& velocity_m_per_s) const {
  std::vector<double> state;
  for (const double q : displacement_m) state.push_back(q / length_m);
  for (const double v : velocity_m_per_s) state.push_back(v / unit_velocity_m_per_s());
  return state;
}

Eigen::VectorXd StateScale::displacement_m(std::span<const double> state) const {
  return length_m * numbers(state.first(state.size() / 2));
}

Eigen::VectorXd StateScale::velocity_m_per_s(std::span<const double> state) const {
  return unit_velocity_m_per_s() * numbers(state.last(state.size() / 2));
}

StateScale state_scale(const scene::Scene& scene) { return {scene.length_scale_m, scene.speed_rad_per_s}; }

std::vector<double> scaled_initial_state(const scene::Scene& scene) {
  return state_scale(scene).state(scene.displacement_m, scene.velocity_m_per_s);
}

void set_initial_state(scene::Scene& scene, std::span<const double> section) {
  const StateScale scale = state_scale(scene);
  scene.displacement_m = scale.displacement_m(section);
  scene.velocity_m_per_s = scale.velocity_m_per_s(section);
}

scene::Scene scene_at(scene::Scene scene, std::span<const double> section, long revolution) {
  set_initial_state(scene, section);
  scene.elapsed_revolutions += revolution;
  for (scene::Pulse& pulse : scene.pulses)
    pulse.elapsed_s += static_cast<double>(revolution) * scene.period_s();
  return scene;
}

}  // namespace rubsweep::integrate::run
