#include "rubsweep/analysis/branch/orbits/oval_orbits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "rubsweep/analysis/branch/orbits/approaches.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/response/rotating/rotating_flow.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::branch::orbits {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using response::rotating::RotatingArc;
using response::rotating::RotatingField;
using response::rotating::RotatingFlow;

constexpr double nearest_maximum = 0.2;  ///< share of a loop; a maximum farther away is not the expected one
/// tolerance; a small step along the motion covers the remaining angle
constexpr double landed_rad = 1e-9;
constexpr int most_steps = 12;

integrate::run::SolverOptions exact(integrate::run::SolverOptions solver) {
  solver.relative_tolerance = std::min(solver.relative_tolerance, tolerance_of_orbits);
  return solver;
}

/// One scene of the family with the flows that are needed to follow ovals in it.
struct OvalScene {
  double parameter = 0;
  scene::Scene scene;
  RotatingField field;
  RotatingFlow flow, sampled_flow;

  OvalScene(double at, const scene::Scene& with_pulses, const integrate::run::SolverOptions& solver)
      : parameter(at),
        scene(response::proof::after_the_kick(with_pulses)),
        field(scene, solver),
        flow(scene, solver, 0),
        sampled_flow(flow.with(solver.relative_tolerance, samples_per_turn)) {}

  /// Half the rate of change of the squared distance between the observed point and the axis. This rate and
  /// its derivative by the state are the same in the rotating and in the fixed frame.
  double outward(const VectorXd& y) const {
    const Eigen::Index n = y.size() / 2;
    return (scene::observed(scene) * y.head(n)).dot(scene::observed(scene) * y.tail(n));
  }
  VectorXd outward_slope(const VectorXd& y) const {
    const Eigen::Index n = y.size() / 2;
    VectorXd slope(y.size());
    const auto& observed = scene::observed(scene);
    slope << observed.transpose() * (observed * y.tail(n)), observed.transpose() * (observed * y.head(n));
    return slope;
  }

  /// Angle of shaft rotation from `y` to the nearest maximum, by one Newton step; NaN where the extreme is no
  /// maximum.
  double angle_to_maximum(const VectorXd& y) const {
    const double curvature = outward_slope(y).dot(field.rate(y));
    return curvature < 0 ? -outward(y) / curvature : std::numeric_limits<double>::quiet_NaN();
  }
};

struct Landing {
  VectorXd y;
  double angle_rad = 0;
};

/// Follows `y` to the maximum nearest to its state at `expected_rad`.
std::optional<Landing> land(const OvalScene& at, const VectorXd& y, double expected_rad, double loop_rad) {
  double angle = expected_rad;
  for (int i = 0; i < most_steps; ++i) {
    const auto end = at.flow.end_from(y, angle);
    if (!end || !end->allFinite()) return std::nullopt;
    const double step = at.angle_to_maximum(*end);
    angle += step;
    if (!(std::abs(angle - expected_rad) < nearest_maximum * loop_rad)) return std::nullopt;
    if (std::abs(step) < landed_rad) return Landing{*end + step * at.field.rate(*end), angle};
  }
  return std::nullopt;
}

class OvalOrbits {
 public:
  OvalOrbits(SceneFamily family, int loops, const integrate::run::SolverOptions& solver)
      : family_(std::move(family)), loops_(loops), solver_(exact(solver)) {}

  /// Advances by `loops`, an integer, or by 0.5 to the maximum half a loop later.
  Evaluation advance(double loops, double parameter, VectorXd& state, MatrixXd* monodromy) {
    OvalScene* at = scene_at(parameter);
    if (at == nullptr) return Evaluation::infeasible;
    const Eigen::Index n = state.size() - 1;
    const double loop_rad = numerics::full_turn * state(n);
    if (!(loop_rad > 0) || !std::isfinite(loop_rad)) return Evaluation::failed;
    const VectorXd y = state.head(n);
    const auto landing = land(*at, y, loops * loop_rad, std::min(loops, 1.0) * loop_rad);
    if (!landing) return Evaluation::failed;
    state << landing->y, landing->angle_rad / (loops * numerics::full_turn);
    if (monodromy == nullptr) return Evaluation::ok;
    const auto arc = at->flow.from(y, landing->angle_rad);
    if (!arc || !arc->transition.allFinite()) return Evaluation::failed;
    // A change of the initial state also shifts the maximum along the motion.
    const VectorXd slope = at->outward_slope(arc->end), rate = at->field.rate(arc->end);
    const Eigen::RowVectorXd angle_by_start = -(slope.transpose() * arc->transition) / slope.dot(rate);
    *monodromy = MatrixXd::Zero(n + 1, n + 1);
    monodromy->topLeftCorner(n, n) = arc->transition + rate * angle_by_start;
    monodromy->bottomLeftCorner(1, n) = angle_by_start / (loops * numerics::full_turn);
    return Evaluation::ok;
  }

  std::optional<OrbitFacts> facts(double parameter, const VectorXd& state) {
    OvalScene* at = scene_at(parameter);
    if (at == nullptr) return std::nullopt;
    OrbitFacts facts;
    for (int loops = 0; loops < loops_; ++loops) {
      VectorXd section = state;
      if (loops > 0 && advance(loops, parameter, section, nullptr) != Evaluation::ok) return std::nullopt;
      section(state.size() - 1) = state(state.size() - 1);  // loop time: the mean of all loops
      facts.sections.push_back(section);
    }
    const Eigen::Index n = state.size() - 1;
    const double period_rad = loops_ * numerics::full_turn * state(n);
    if (loops_ == 1) add_half_way(*at, state, facts);
    const auto arc = at->sampled_flow.from(state.head(n), period_rad);
    if (!arc) return std::nullopt;
    facts.period_turns = loops_ * state(n);
    facts.hits = arc->hits;
    facts.contact_fraction = arc->contact_fraction;
    facts.touched = arc->contact_fraction > 0;
    facts.feasible = !arc->slip_reversed;
    facts.peak_displacement_m = arc->peak_displacement_m;
    facts.peak_contact_force_n = arc->peak_contact_force_n;
    facts.amplitude_m = arc->peak_displacement_m;  // distance from the axis, the centre of the oval
    facts.switches = arc->switches;
    EvenContacts even(at->scene);
    even.add(arc->samples);
    even.settle(facts);
    // As for all orbits, phases grow by 2 pi for each turn of the order.
    for (integrate::run::ModeSwitch& change : facts.switches) change.phase_rad /= state(n);
    return facts;
  }

  /// Finds changes and approaches, but no approaches between the last whole sample and the end of the period.
  std::optional<ContactPassages> passages(double parameter, const VectorXd& state) {
    OvalScene* at = scene_at(parameter);
    if (at == nullptr) return std::nullopt;
    const double turns = state(state.size() - 1);
    auto arc = at->sampled_flow.from(state.head(state.size() - 1), loops_ * numerics::full_turn * turns);
    if (!arc) return std::nullopt;
    ContactPassages passages;
    passages.approaches = approaches_of(
        at->scene, {std::move(arc->samples), numerics::full_turn / samples_per_turn, false}, arc->switches);
    passages.switches = std::move(arc->switches);
    // As for all orbits, phases grow by 2 pi for each turn of the order.
    for (Approach& approach : passages.approaches) approach.phase_rad /= turns;
    for (integrate::run::ModeSwitch& change : passages.switches) change.phase_rad /= turns;
    return passages;
  }

 private:
  /// Adds the maximum half a period later, if there is one. Where the two halves of a loop become equal, the
  /// oval joins the branch of half its period.
  static void add_half_way(const OvalScene& at, const VectorXd& state, OrbitFacts& facts) {
    const Eigen::Index n = state.size() - 1;
    const double half_rad = numerics::full_turn * state(n) / 2;
    const auto landing = land(at, state.head(n), half_rad, half_rad);
    if (!landing) return;
    facts.sections.push_back(state);
    facts.sections.back().head(n) = landing->y;
  }

  OvalScene* scene_at(double parameter) {
    if (OvalScene* at = recent_.find([&](const OvalScene& one) { return one.parameter == parameter; }))
      return at;
    const auto scene = family_(parameter);
    if (!scene || !response::rotating::rotationally_symmetric(*scene)) return nullptr;
    OvalScene& made = recent_.emplace(parameter, *scene, solver_);
    recent_.trim();
    return &made;
  }

  SceneFamily family_;
  int loops_;
  integrate::run::SolverOptions solver_;
  numerics::RecentlyUsed<OvalScene> recent_{
      3};  ///< an orbit and two neighbours, for the derivative by the parameter
};

}  // namespace

OrbitProblem oval_orbits(SceneFamily family, int loops, const integrate::run::SolverOptions& solver) {
  const auto orbits = std::make_shared<OvalOrbits>(std::move(family), loops, solver);
  OrbitProblem problem = problem_of_whole_turns(orbits, loops);
  if (loops == 1) {
    problem.half_returns = [orbits](double parameter, VectorXd& state, MatrixXd* monodromy) {
      return orbits->advance(0.5, parameter, state, monodromy);
    };
  }
  return problem;
}

std::optional<VectorXd> oval_state(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                                   const VectorXd& point, double period_rad) {
  const OvalScene at(0, scene, exact(solver));
  const auto arc = at.sampled_flow.from(point, period_rad);
  if (!arc || arc->samples.cols() == 0) return std::nullopt;
  Eigen::Index farthest = 0;
  (scene::observed(at.scene) * arc->samples.topRows(point.size() / 2))
      .colwise()
      .squaredNorm()
      .maxCoeff(&farthest);
  const double angle = numerics::full_turn * static_cast<double>(farthest) / samples_per_turn;
  const VectorXd near = response::rotating::turned(arc->samples.col(farthest), -angle);
  const auto landing = land(at, near, period_rad, period_rad);
  if (!landing) return std::nullopt;
  VectorXd state(point.size() + 1);
  state << landing->y, period_rad / numerics::full_turn;
  return state;
}

}  // namespace rubsweep::branch::orbits
