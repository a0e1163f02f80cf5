#include "rubsweep/core/response/motion/record.hpp"

#include "rubsweep/core/scene/observed.hpp"

namespace rubsweep::response::motion {

Record::Record(const scene::Scene& scene, const ResponseOptions& options)
    : options_(options),
      map_(scene::observed(scene) * scene.length_scale_m),
      length_scale_m_(scene.length_scale_m),
      states_(2 * static_cast<std::size_t>(scene.structure.coordinates())) {
  const auto turns = static_cast<std::size_t>(2 * options.window_revolutions);
  displacement_m_.reserve(turns * static_cast<std::size_t>(options.samples_per_revolution));
  facts_.reserve(turns);
  section_.reserve((turns + 1) * states_);
}

void Record::begin(std::span<const double> section) {
  displacement_m_.clear();
  facts_.clear();
  section_.assign(section.begin(), section.end());
}

void Record::add(const integrate::run::TurnReport& turn) {
  const double* q = turn.samples.data();
  for (int k = 0; k < turn.sample_count; ++k, q += states_) {
    double x = 0, y = 0;
    for (Eigen::Index j = 0; j < map_.cols(); ++j) {
      x += map_(0, j) * q[j];
      y += map_(1, j) * q[j];
    }
    displacement_m_.emplace_back(x, y);
  }
  section_.insert(section_.end(), turn.section.begin(), turn.section.end());
  facts_.push_back(facts_of(turn));
}

Window Record::window(std::size_t which) const {
  const auto turns = static_cast<std::size_t>(options_.window_revolutions);
  const std::size_t samples = turns * static_cast<std::size_t>(options_.samples_per_revolution);
  Window window;
  window.turns = options_.window_revolutions;
  window.samples_per_revolution = options_.samples_per_revolution;
  window.clearance_m = length_scale_m_;
  window.displacement_m = std::span(displacement_m_).subspan(which * samples, samples);
  window.states = static_cast<int>(states_);
  window.section = std::span(section_).subspan(which * turns * states_, (turns + 1) * states_);
  window.contact = std::span(facts_).subspan(which * turns, turns);
  return window;
}

}  // namespace rubsweep::response::motion
