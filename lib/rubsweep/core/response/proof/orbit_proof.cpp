#include "rubsweep/core/response/proof/orbit_proof.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/impulses.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/proof/approach.hpp"
#include "rubsweep/core/response/proof/orbit_ball.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"

namespace rubsweep::response::proof {
namespace {

std::vector<double> numbers_of(const model::Friction& friction) {
  std::vector<double> numbers;
  std::visit(
      [&numbers](const auto& law) {
        law.visit_fields(law, [&numbers](auto&&, double value, auto&&) { numbers.push_back(value); });
      },
      friction);
  return numbers;
}

bool same_friction(const model::Friction& a, const model::Friction& b) {
  return a.index() == b.index() && numbers_of(a) == numbers_of(b);
}

bool equal(const structure::LinearSystem& structure, const scene::Contact& a, const scene::Contact& b) {
  return !a.casing_point && !b.casing_point && !a.law && !b.law &&
         scene::relative_map(structure, a) == scene::relative_map(structure, b) &&
         contact::same(a.wall, b.wall) && a.clearance_m == b.clearance_m &&
         a.damping_ns_per_m * b.stiffness_n_per_m == b.damping_ns_per_m * a.stiffness_n_per_m &&
         a.surface_speed_m_per_s == b.surface_speed_m_per_s && same_friction(a.friction, b.friction);
}

/// Tolerance that is tight enough for derivatives by finite differences.
constexpr double tolerance_of_a_proof = 1e-11;

constexpr double rough_accuracy = 1e-6;  ///< Accuracy of derivatives for the first Newton steps to an orbit.

/// Share of its distance down to which a transient is followed where no ball about the orbit is known, unless
/// the test of linear convergence is passed earlier.
constexpr double followed_down = 1e-4;

/// Limits for following a transient: 64 periods plus what its norm promises, up to a maximum. Turns without
/// closed forms cost a hundred times more.
Patience patience(const StableOrbit& orbit, bool closed_forms) {
  constexpr double periods = 64;
  return {.start = periods * orbit.order, .most = closed_forms ? 200'000.0 : 1'000.0};
}

std::vector<double> start_of(const StableOrbit& orbit) {
  return {orbit.sections.front().begin(), orbit.sections.front().end()};
}

}  // namespace

OrbitProof::OrbitProof(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                       const motion::ResponseOptions& options, motion::Workspace& workspace,
                       integrate::run::WorkBudget& budget)
    : scene_(after_the_kick(scene)),
      distinct_(with_equal_stops_as_one(scene_)),
      run_solver_(solver),
      solver_(solver),
      options_(options),
      workspace_(workspace),
      budget_(budget),
      search_(2 * static_cast<std::size_t>(scene.structure.coordinates()), 2 * options.max_order),
      remembers_(integrate::run::remembers_impacts(scene_)) {
  solver_.relative_tolerance = std::min(solver.relative_tolerance, tolerance_of_a_proof);
}

std::optional<motion::ProvenMotion> OrbitProof::look(const integrate::run::TurnReport& turn) {
  if (budget_.used_up()) return std::nullopt;
  search_.add(turn.section, turn.touched);
  if (remembers_ && turn.touching_at_end) return std::nullopt;
  const auto order = search_.candidate();
  if (!order) return std::nullopt;
  auto proven = prove(turn.section, *order);
  if (!proven) search_.refuse(*order);
  return proven;
}

/// Turns at the tolerance of the run.
TurnMap OrbitProof::as_it_runs() {
  if (!run_map_) run_map_.emplace(scene_, run_solver_, workspace_.modes, &budget_);
  return [this](std::span<double> state, Eigen::MatrixXd*) { return run_map_->go_on(state); };
}

TurnMap OrbitProof::at_tight_tolerance(double tangent_accuracy) {
  if (!map_) map_.emplace(scene_, solver_, workspace_.modes, &budget_);
  return [this, tangent_accuracy](std::span<double> state, Eigen::MatrixXd* disturbances) {
    return disturbances ? map_->carry(state, *disturbances, tangent_accuracy) : map_->go_on(state);
  };
}

std::optional<motion::ProvenMotion> OrbitProof::prove(std::span<const double> section, int order) {
  const TurnMap roughly = at_tight_tolerance(rough_accuracy);
  const auto orbit = find_orbit(at_tight_tolerance(), section, order, &roughly);
  if (!orbit) return std::nullopt;
  const auto proof = converges(section, *orbit);
  if (!proof) return std::nullopt;
  const auto measures = measure(start_of(*orbit), orbit->order);
  if (!measures) return std::nullopt;
  return motion::ProvenMotion{motion::class_of_period(orbit->order, *measures), orbit->order, *measures,
                              orbit->floquet_modulus, *proof};
}

/// Follows the transient until it enters a ball, or, where there is none, until it is observed to converge.
std::optional<motion::Proof> OrbitProof::converges(std::span<const double> section,
                                                   const StableOrbit& orbit) {
  if (map_->exact() && enters_split_ball(section, orbit)) return motion::Proof::floquet;
  const auto norms = adapted_norms(orbit.transitions);
  if (!norms) return std::nullopt;
  const auto radius =
      map_->exact() ? ball_radius(distinct_, workspace_.modes, start_of(orbit), *norms) : std::nullopt;
  const double distance = adapted_distance(section, orbit, *norms);
  const Nearness wanted =
      radius ? Nearness{.adapted = *radius} : Nearness{followed_down * distance, on_the_orbit, true};
  if (!comes_near(radius ? at_tight_tolerance() : as_it_runs(), section, orbit, *norms, wanted,
                  patience(orbit, map_->closed_forms())))
    return std::nullopt;
  return radius ? motion::Proof::floquet : motion::Proof::floquet_observed;
}

/// Tries the split ball, in which weakly damped modes parallel to the wall may stay large, and checks whether
/// the transient enters it. Most transients are inside from the start.
bool OrbitProof::enters_split_ball(std::span<const double> section, const StableOrbit& orbit) {
  const auto norms = split_norms(orbit.transitions, seen_by_contacts(distinct_));
  if (!norms) return false;
  const Eigen::Map<const Eigen::VectorXd> here(section.data(), static_cast<Eigen::Index>(section.size()));
  const auto distance = parts_of(*norms, 0, here - orbit.sections.front());
  const auto radii = split_ball_radii(distinct_, workspace_.modes, start_of(orbit), *norms, distance);
  return radii &&
         comes_inside(at_tight_tolerance(), section, orbit, *norms, *radii,
                      patience(orbit, map_->closed_forms()).turns(turns_to_enter(*norms, distance, *radii)));
}

/// Measures over exactly one period; empty when the orbit touches nothing.
std::optional<motion::Measures> OrbitProof::measure(const std::vector<double>& section, int order) {
  motion::ResponseOptions window = options_;
  window.window_revolutions = order;
  motion::Record record(scene_, window);
  record.begin(section);
  const auto turns =
      motion::record_settled(scene_, solver_, workspace_.modes,
                             {.start = section,
                              .turns = order,
                              .samples_per_revolution = options_.samples_per_revolution,
                              .peaks = true,
                              .take = [&](const motion::RecordedTurn& turn) { record.add(turn.report); }});
  if (!turns || !turns->touched) return std::nullopt;
  return motion::measure_window(record.window(0), workspace_.spectrum);
}

scene::Scene with_equal_stops_as_one(scene::Scene scene) {
  // Twist has members that are indexed by contact, so no contact may be removed.
  if (scene.twist) return scene;
  std::vector<scene::Contact> distinct;
  for (const scene::Contact& contact : scene.contacts) {
    const auto found = std::ranges::find_if(
        distinct, [&](const scene::Contact& other) { return equal(scene.structure, contact, other); });
    if (found == distinct.end()) {
      distinct.push_back(contact);
    } else {
      found->stiffness_n_per_m += contact.stiffness_n_per_m;
      found->damping_ns_per_m += contact.damping_ns_per_m;
    }
  }
  scene.contacts = std::move(distinct);
  return scene;
}

}  // namespace rubsweep::response::proof
