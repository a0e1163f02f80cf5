#include "rubsweep/response/section_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/error.hpp"
#include "rubsweep/response/floquet.hpp"

namespace rubsweep::response {
namespace {

/// Differences of this width: their own error (its square) and that of a solver at 1e-11 both stay near 1e-6.
constexpr double difference_step = 1e-5;

}  // namespace

scene::Scene after_the_kick(scene::Scene scene) {
  scene.pulse.reset();
  return scene;
}

SceneMap::SceneMap(const scene::Scene& scene, const integrate::SolverOptions& solver,
                   integrate::ExactPlans& plans)
    : states_(2 * static_cast<std::size_t>(scene.structure.coordinates())),
      exact_(integrate::solver_of(scene, solver) == integrate::Solver::exact),
      run_(integrate::start(after_the_kick(scene), solver, plans)) {}

bool SceneMap::advance(std::span<double> section) {
  if (section.size() != states_) {
    throw SolverError(fmt::format("a section of {} coordinates has {} numbers, got {}", states_ / 2, states_,
                                  section.size()));
  }
  run_.restart(section);
  if (run_.advance(turn_) != integrate::Outcome::ok) return false;
  std::ranges::copy(turn_.section, section.begin());
  return true;
}

bool SceneMap::operator()(std::span<double> section) {
  turn_.transition_wanted = false;
  return advance(section);
}

bool SceneMap::differentiate_exactly(std::span<double> section, Eigen::MatrixXd& transition, bool& exact) {
  const long adaptive_turns = turn_.effort.adaptive_turns;
  turn_.transition_wanted = exact_;
  if (!advance(section)) return false;
  exact = exact_ && turn_.effort.adaptive_turns == adaptive_turns;
  if (exact) transition = turn_.transition;
  return true;
}

bool SceneMap::differentiate(std::span<double> section, Eigen::MatrixXd& transition) {
  if (exact_) {
    std::vector<double> next(section.begin(), section.end());
    bool exact = false;
    if (!differentiate_exactly(next, transition, exact)) return false;
    if (exact) {
      std::ranges::copy(next, section.begin());
      return true;
    }
  }
  return response::differentiate([this](std::span<double> s) { return (*this)(s); }, section, difference_step,
                                 transition);
}

}  // namespace rubsweep::response
