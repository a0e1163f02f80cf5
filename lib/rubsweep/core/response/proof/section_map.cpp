#include "rubsweep/core/response/proof/section_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/flight_run.hpp"
#include "rubsweep/core/integrate/run/impulses.hpp"
#include "rubsweep/core/response/proof/periodic_orbit.hpp"

namespace rubsweep::response::proof {
namespace {

/// Step of difference quotients. Their truncation error and the error from a solver at 1e-11 are then both
/// near 1e-6.
constexpr double difference_step = 1e-5;

}  // namespace

scene::Scene after_the_kick(scene::Scene scene) {
  scene.pulses.clear();
  return scene;
}

SceneMap::SceneMap(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                   integrate::exact::modes::ModeCache& modes, integrate::run::WorkBudget* budget)
    : states_(2 * static_cast<std::size_t>(scene.structure.coordinates())),
      exact_(integrate::solver_of(scene, solver) == integrate::Solver::exact),
      counts_on_(exact_ || integrate::may_fly(scene, solver)),
      run_(integrate::start(after_the_kick(scene), solver, modes)),
      budget_(budget),
      // Steppers also move tangent vectors, if there are contacts whose law is not linear.
      moves_tangents_(exact_ ||
                      std::ranges::any_of(scene.contacts, [](const auto& c) { return c.law != nullptr; })),
      remembers_(integrate::run::remembers_impacts(scene)) {}

bool SceneMap::advance(std::span<double> section, bool continues) {
  if (section.size() != states_) {
    throw SolverError(fmt::format("a section of {} coordinates has {} numbers, got {}", states_ / 2, states_,
                                  section.size()));
  }
  if (budget_ && budget_->used_up()) return false;
  const bool goes_on = (continues || keeps_memory_) && whole_ && std::ranges::equal(section, report_.section);
  if (!goes_on) run_.restart(section);
  const integrate::run::Outcome outcome = run_.advance(request_, report_);
  whole_ = outcome == integrate::run::Outcome::ok;
  if (budget_) spend(counts_on_ || goes_on);
  if (!whole_ || (remembers_ && !keeps_memory_ && report_.touching_at_end)) return false;
  std::ranges::copy(report_.section, section.begin());
  return true;
}

/// A run with closed forms goes on counting after a restart, a stepper begins anew.
void SceneMap::spend(bool counts_on) {
  const double before = std::exchange(work_, integrate::run::work(report_.effort));
  budget_->spend(counts_on ? work_ - before : work_);
}

bool SceneMap::operator()(std::span<double> section) {
  request_.tangent_vectors.resize(0, 0);
  return advance(section);
}

bool SceneMap::go_on(std::span<double> section) {
  request_.tangent_vectors.resize(0, 0);
  return advance(section, exact_);
}

bool SceneMap::carry_exactly(std::span<double> section, Eigen::MatrixXd& disturbances, bool& moved,
                             double accuracy) {
  request_.tangent_accuracy = accuracy;
  request_.tangent_vectors = disturbances;
  const bool made = advance(section);
  const Eigen::MatrixXd* at_end = made ? report_.tangent_vectors.get() : nullptr;
  moved = at_end != nullptr;
  if (at_end) disturbances = *at_end;
  return made;
}

bool SceneMap::carry(std::span<double> section, Eigen::MatrixXd& disturbances, double accuracy) {
  if (moves_tangents_) {
    before_.assign(section.begin(), section.end());
    bool moved = false;
    if (!carry_exactly(section, disturbances, moved, accuracy)) return false;
    if (moved) return true;
    std::ranges::copy(before_, section.begin());
  }
  Eigen::MatrixXd transition;
  if (!differentiate([this](std::span<double> s) { return (*this)(s); }, section, difference_step,
                     transition)) {
    return false;
  }
  disturbances = transition * disturbances;
  return true;
}

}  // namespace rubsweep::response::proof
