#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"

#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <utility>

#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::branch::orbits {
namespace {

/// Step in shaft rotation for the second derivative of a guard. The truncation error and the rounding error
/// of the central difference are then about equal, near 1e-10.
constexpr double difference_step_rad = 1e-5;

constexpr double turn_rad = 2 * std::numbers::pi;
/// Samples per turn. A sample is within a thousandth of a radian of the wanted phase, near enough for
/// Newton's iteration.
constexpr int section_samples_per_turn = 4096;

std::span<const double> numbers(const Eigen::VectorXd& state) {
  return {state.data(), static_cast<std::size_t>(state.size())};
}

/// Moves a stop so far away that nothing reaches it.
void move_away(scene::Scene& scene, int contact) {
  constexpr double far_away = 1e3;
  scene.contacts[static_cast<std::size_t>(contact)].clearance_m += far_away * scene.length_scale_m;
}

class ScenePlaneOrbits {
 public:
  ScenePlaneOrbits(ScenePlane plane, int order, const integrate::run::SolverOptions& solver,
                   integrate::exact::modes::ModeCache& modes)
      : plane_(std::move(plane)), order_(order), solver_(solver), modes_(modes) {}

  Evaluation returns(const PlanePoint& place, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy) {
    return line_at(place).returns(place.first, state, monodromy);
  }

  std::optional<OrbitFacts> facts(const PlanePoint& place, const Eigen::VectorXd& state) {
    return line_at(place).facts(place.first, state);
  }

  std::optional<GuardMotion> guard(const PlanePoint& place, const Eigen::VectorXd& state,
                                   const ArmedGuard& armed) {
    if (!guards_ || !(guards_at_ == place)) {
      const auto scene = scene_at(place);
      if (!scene) return std::nullopt;
      guards_ = std::make_unique<SectionGuards>(*scene);
      guards_at_ = place;
    }
    return guards_->at(numbers(state), armed);
  }

  std::optional<Eigen::VectorXd> at_phase(const PlanePoint& place, const Eigen::VectorXd& state,
                                          double& phase_rad) {
    const auto scene = scene_at(place);
    // With torsion the unbalance also turns with the twist, which `begun_at_phase` ignores.
    if (!scene || scene->twist) return std::nullopt;
    const integrate::run::Run run = integrate::start(*scene, solver_, modes_);
    const auto sample = std::llround(phase_rad / turn_rad * section_samples_per_turn);
    integrate::run::TurnRequest request;
    request.samples_per_revolution = section_samples_per_turn;
    integrate::run::TurnReport report;
    run.restart(numbers(state));
    for (long long turn = 0; turn <= sample / section_samples_per_turn; ++turn)
      if (run.advance(request, report) != integrate::run::Outcome::ok) return std::nullopt;
    phase_rad = turn_rad * static_cast<double>(sample) / section_samples_per_turn;
    const Eigen::Map<const Eigen::MatrixXd> samples(report.samples.data(), state.size(), report.sample_count);
    return samples.col(sample % section_samples_per_turn);
  }

 private:
  struct Line {
    PlanePoint place;  ///< point of the plane for which the guards are made; its first parameter is arbitrary
    OrbitProblem orbits;
  };

  const OrbitProblem& line_at(const PlanePoint& place) {
    const Line* known = recent_.find([&](const Line& line) {
      return PlanePoint{place.first, line.place.second, line.place.phase_rad, line.place.clear_of} == place;
    });
    if (known != nullptr) return known->orbits;
    const auto family = [plane = plane_, place](double first) -> std::optional<scene::Scene> {
      auto scene = plane(first, place.second);
      if (scene && place.clear_of >= 0) move_away(*scene, place.clear_of);
      if (!scene || place.phase_rad == 0) return scene;
      return begun_at_phase(std::move(*scene), place.phase_rad);
    };
    Line& line = recent_.emplace(Line{place, scene_orbits(family, order_, solver_, modes_)});
    recent_.trim();
    return line.orbits;
  }

  std::optional<scene::Scene> scene_at(const PlanePoint& place) const {
    auto scene = plane_(place.first, place.second);
    if (!scene) return std::nullopt;
    return begun_at_phase(response::proof::after_the_kick(std::move(*scene)), place.phase_rad);
  }

  ScenePlane plane_;
  int order_;
  integrate::run::SolverOptions solver_;
  integrate::exact::modes::ModeCache& modes_;
  numerics::RecentlyUsed<Line> recent_{3};  ///< cache of a line and its neighbours for derivatives
  std::unique_ptr<SectionGuards> guards_;
  PlanePoint guards_at_;
};

}  // namespace

SectionGuards::SectionGuards(const scene::Scene& scene)
    : system_(integrate::run::scale<Eigen::Dynamic>(scene)), dynamics_(system_, 0) {}

std::optional<GuardMotion> SectionGuards::at(std::span<const double> section, const ArmedGuard& guard) {
  const State state(section.begin(), section.end());
  enter_modes(state, guard);
  const auto here = guard_at(state, 0, guard);
  if (!here) return std::nullopt;
  State rate(state.size());
  dynamics_(state, rate, 0);
  State before = state, behind = state;
  for (std::size_t i = 0; i < state.size(); ++i) {
    before[i] -= difference_step_rad * rate[i];
    behind[i] += difference_step_rad * rate[i];
  }
  const auto earlier = guard_at(before, -difference_step_rad, guard),
             later = guard_at(behind, difference_step_rad, guard);
  return GuardMotion{here->value, here->rate, (later->rate - earlier->rate) / (2 * difference_step_rad)};
}

/// Guard in units of length: a guard of forces is divided by the stiffness.
std::optional<contact::Guard> SectionGuards::guard_at(const State& state, double phase_rad,
                                                      const ArmedGuard& guard) const {
  const auto i = static_cast<std::size_t>(guard.contact);
  const auto& contact = system_.contacts[i];
  State rate(state.size());
  dynamics_(state, rate, phase_rad);
  const contact::Guards guards = contact::guards_of(guard.from, contact.stiffness, contact.damping,
                                                    dynamics_.kinematics(i, state, rate));
  const contact::GuardForms forms = contact::guard_forms(guard.from, contact.damping > 0);
  for (std::size_t k = 0; k < static_cast<std::size_t>(guards.count); ++k) {
    contact::Guard found = guards.list[k];
    if (found.next != guard.to) continue;
    if (forms.list[k].damper != 0) {
      found.value /= contact.stiffness;
      found.rate /= contact.stiffness;
    }
    return found;
  }
  return std::nullopt;
}

void SectionGuards::enter_modes(const State& state, const ArmedGuard& guard) {
  auto& modes = dynamics_.modes();
  modes.assign(modes.size(), contact::Mode::open);
  State rate(state.size());
  dynamics_(state, rate, 0);
  for (std::size_t i = 0; i < modes.size(); ++i) dynamics_.enter_by_state(i, state, rate);
  modes[static_cast<std::size_t>(guard.contact)] = guard.from;
}

scene::Scene begun_at_phase(scene::Scene scene, double phase_rad) {
  scene.harmonic_n *= std::polar(1.0, phase_rad);
  scene.second_harmonic_n *= std::polar(1.0, 2 * phase_rad);
  for (structure::ImpulseTrain& train : scene.impulses) {
    const double periods = train.phase_periods - train.multiple * phase_rad / (2 * std::numbers::pi);
    const double rest = periods - std::floor(periods);
    train.phase_periods = rest < 1 ? rest : 0;
  }
  return scene;
}

PlaneOrbits scene_plane_orbits(ScenePlane plane, int order, const integrate::run::SolverOptions& solver,
                               integrate::exact::modes::ModeCache& modes) {
  const auto orbits = std::make_shared<ScenePlaneOrbits>(std::move(plane), order, solver, modes);
  return {std::bind_front(&ScenePlaneOrbits::returns, orbits),
          std::bind_front(&ScenePlaneOrbits::facts, orbits),
          std::bind_front(&ScenePlaneOrbits::guard, orbits),
          std::bind_front(&ScenePlaneOrbits::at_phase, orbits),
          order,
          {},
          {}};
}

}  // namespace rubsweep::branch::orbits
