#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "rubsweep/analysis/branch/orbits/approaches.hpp"
#include "rubsweep/analysis/branch/orbits/oval_orbits.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/run/impulses.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/response/rotating/apex_return_search.hpp"
#include "rubsweep/core/response/rotating/limit_cycle.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::branch::orbits {
namespace {

/// One scene of the family with the data that are needed to follow orbits in it.
struct SceneAt {
  double parameter = 0;
  scene::Scene scene;
  response::proof::SceneMap map;
  integrate::run::Run run;

  SceneAt(double at, const scene::Scene& with_pulses, const integrate::run::SolverOptions& solver,
          integrate::exact::modes::ModeCache& modes)
      : parameter(at),
        scene(response::proof::after_the_kick(with_pulses)),
        map(scene, solver, modes),
        run(integrate::start(scene, solver, modes)) {}
};

std::span<double> numbers(Eigen::VectorXd& state) {
  return {state.data(), static_cast<std::size_t>(state.size())};
}

class SceneOrbits {
 public:
  SceneOrbits(SceneFamily family, int order, const integrate::run::SolverOptions& solver,
              integrate::exact::modes::ModeCache& modes)
      : family_(std::move(family)), order_(order), solver_(solver), modes_(modes) {
    solver_.relative_tolerance = std::min(solver.relative_tolerance, tolerance_of_orbits);
  }

  Evaluation advance(int turns, double parameter, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy) {
    SceneAt* at = scene_at(parameter);
    if (at == nullptr) return Evaluation::infeasible;
    if (monodromy) *monodromy = Eigen::MatrixXd::Identity(state.size(), state.size());
    for (int turn = 0; turn < turns; ++turn) {
      const bool made = monodromy ? at->map.carry(numbers(state), *monodromy) : at->map(numbers(state));
      if (!made || !state.allFinite()) return Evaluation::failed;
    }
    return Evaluation::ok;
  }

  std::optional<OrbitFacts> facts(double parameter, Eigen::VectorXd state) {
    SceneAt* at = scene_at(parameter);
    if (at == nullptr) return std::nullopt;
    const auto& observed = scene::observed(at->scene);
    const integrate::run::TurnRequest request{
        .samples_per_revolution = samples_per_turn, .peaks = true, .switches = true};
    integrate::run::TurnReport report;
    OrbitFacts facts;
    facts.period_turns = order_;
    std::vector<Eigen::Vector2d> places_m;
    EvenContacts even(at->scene);
    for (int turn = 0; turn < order_; ++turn) {
      facts.sections.push_back(state);
      at->run.restart(numbers(state));
      if (at->run.advance(request, report) != integrate::run::Outcome::ok) return std::nullopt;
      add(report, turn, facts);
      if (report.slip_reversed) facts.feasible = false;
      const Eigen::Map<const Eigen::MatrixXd> samples(report.samples.data(), state.size(),
                                                      report.sample_count);
      for (Eigen::Index k = 0; k < samples.cols(); ++k) {
        places_m.emplace_back(at->scene.length_scale_m * (observed * samples.col(k).head(state.size() / 2)));
      }
      if (has_modes()) even.add(samples);
      std::ranges::copy(report.section, state.begin());
    }
    facts.contact_fraction /= order_;
    facts.amplitude_m = amplitude_of(places_m);
    if (has_modes()) even.settle(facts);
    return facts;
  }

  /// Computes the passages in the same way as the facts, without peaks.
  std::optional<ContactPassages> passages(double parameter, Eigen::VectorXd state) {
    SceneAt* at = scene_at(parameter);
    if (at == nullptr) return std::nullopt;
    const integrate::run::TurnRequest request{.samples_per_revolution = samples_per_turn, .switches = true};
    integrate::run::TurnReport report;
    ContactPassages passages;
    SampledOrbit orbit{Eigen::MatrixXd(state.size(), order_ * samples_per_turn),
                       2 * std::numbers::pi / samples_per_turn};
    for (int turn = 0; turn < order_; ++turn) {
      at->run.restart(numbers(state));
      if (at->run.advance(request, report) != integrate::run::Outcome::ok) return std::nullopt;
      add_switches(report, turn, passages.switches);
      orbit.states.middleCols(turn * samples_per_turn, samples_per_turn) =
          Eigen::Map<const Eigen::MatrixXd>(report.samples.data(), state.size(), samples_per_turn);
      std::ranges::copy(report.section, state.begin());
    }
    passages.approaches = approaches_of(at->scene, orbit, passages.switches);
    return passages;
  }

  double penetration(double parameter, const Eigen::VectorXd& state, int contact) {
    const SceneAt* at = scene_at(parameter);
    return at == nullptr ? std::numeric_limits<double>::quiet_NaN()
                         : penetration_at(at->scene, state, contact);
  }

 private:
  bool has_modes() const { return solver_.contact == integrate::run::ContactHandling::located; }

  static void add_switches(const integrate::run::TurnReport& report, int turn,
                           std::vector<integrate::run::ModeSwitch>& switches) {
    for (integrate::run::ModeSwitch change : report.switches) {
      change.phase_rad += 2 * std::numbers::pi * turn;
      switches.push_back(change);
    }
  }

  static void add(const integrate::run::TurnReport& report, int turn, OrbitFacts& facts) {
    facts.hits += report.hits;
    facts.contact_fraction += report.contact_fraction;
    facts.peak_displacement_m = std::max(facts.peak_displacement_m, report.peak_displacement_m);
    facts.peak_contact_force_n = std::max(facts.peak_contact_force_n, report.peak_contact_force_n);
    facts.touched = facts.touched || report.touched;
    add_switches(report, turn, facts.switches);
  }

  static double amplitude_of(const std::vector<Eigen::Vector2d>& places_m) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& place : places_m) mean += place / static_cast<double>(places_m.size());
    double amplitude = 0;
    for (const Eigen::Vector2d& place : places_m) amplitude = std::max(amplitude, (place - mean).norm());
    return amplitude;
  }

  SceneAt* scene_at(double parameter) {
    if (SceneAt* at = recent_.find([&](const SceneAt& one) { return one.parameter == parameter; })) return at;
    const auto scene = family_(parameter);
    if (!scene) return nullptr;
    if (!integrate::run::same_every_turn(*scene))
      throw ConfigError(
          "impulses that are not the same in every revolution have no orbits to follow, allowed: a whole "
          "number "
          "of impulses in a revolution");
    SceneAt& made = recent_.emplace(parameter, *scene, solver_, modes_);
    recent_.trim();
    return &made;
  }

  SceneFamily family_;
  int order_;
  integrate::run::SolverOptions solver_;
  integrate::exact::modes::ModeCache& modes_;
  numerics::RecentlyUsed<SceneAt> recent_{
      2};  ///< an orbit and one neighbour, for the derivative by the parameter
};

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

OrbitProblem scene_orbits(SceneFamily family, int order, const integrate::run::SolverOptions& solver,
                          integrate::exact::modes::ModeCache& modes) {
  const auto orbits = std::make_shared<SceneOrbits>(std::move(family), order, solver, modes);
  OrbitProblem problem = problem_of_whole_turns(orbits, order);
  problem.penetration = std::bind_front(&SceneOrbits::penetration, orbits);
  return problem;
}

OrbitProblem closed_orbits(Closing closing, SceneFamily family, int order,
                           const integrate::run::SolverOptions& solver,
                           integrate::exact::modes::ModeCache& modes) {
  return closing == Closing::in_the_turning_frame ? oval_orbits(std::move(family), order, solver)
                                                  : scene_orbits(std::move(family), order, solver, modes);
}

using Eigen::VectorXd;
namespace rotating = response::rotating;

std::optional<VectorXd> oval_from(const scene::Scene& with_pulses, const VectorXd& section,
                                  const integrate::run::SolverOptions& solver,
                                  const response::motion::ResponseOptions& options,
                                  response::motion::Workspace& workspace) {
  if (!rotating::rotationally_symmetric(with_pulses)) return std::nullopt;
  const scene::Scene scene = response::proof::after_the_kick(with_pulses);
  const rotating::RotatingField field(scene, solver);
  const rotating::CycleFlows flows(scene, solver, 0);
  const rotating::RotatingMotion motion = flows.motion(field);
  const integrate::run::Run run = integrate::start(scene, solver, workspace.modes);
  run.restart({section.data(), static_cast<std::size_t>(section.size())});
  rotating::ApexReturnSearch search(scene);
  integrate::run::TurnRequest request;
  request.samples_per_revolution = options.samples_per_revolution;
  integrate::run::TurnReport turn;
  for (int revolution = 0; revolution < options.max_revolutions; ++revolution) {
    if (run.advance(request, turn) != integrate::run::Outcome::ok) return std::nullopt;
    search.add(turn);
    const auto candidate = search.candidate();
    if (!candidate) continue;
    const VectorXd here =
        Eigen::Map<const VectorXd>(turn.section.data(), static_cast<Eigen::Index>(turn.section.size()));
    if (const auto cycle = rotating::prove_limit_cycle(motion, here, candidate->periods_rad))
      return oval_state(scene, solver, cycle->state, cycle->once.angle_rad);
    search.refuse(*candidate);
  }
  return std::nullopt;
}

SettledStart settle_on_orbit(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                             const response::motion::ResponseOptions& options,
                             response::motion::Workspace& workspace) {
  const response::SettledRun settled = response::settle(cell, solver, options, workspace);
  SettledStart start{settled.motion.motion_class, settled.motion.order, Closing::with_the_shaft, {}};
  if (start.motion_class == response::motion::MotionClass::quasi_periodic && !settled.section.empty()) {
    auto oval = oval_from(cell.scene, vector_of(settled.section), solver, options, workspace);
    if (oval) start = {start.motion_class, 1, Closing::in_the_turning_frame, std::move(*oval)};
    return start;
  }
  if (!start.order) return start;
  // Second run, to get the last section. If a proof ended the first run, this one ends equally near the
  // orbit.
  const integrate::run::Run run = integrate::start(cell.scene, solver, workspace.modes);
  integrate::run::TurnReport turn;
  if (response::motion::pass_until_settled(run, {.most_turns = settled.revolutions}, turn)) {
    start.state = vector_of(turn.section);
  } else {
    start.order.reset();
  }
  return start;
}

}  // namespace rubsweep::branch::orbits
