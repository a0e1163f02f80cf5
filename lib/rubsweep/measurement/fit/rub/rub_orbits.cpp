#include "rubsweep/measurement/fit/rub/rub_orbits.hpp"

#include <fmt/format.h>

#include <complex>
#include <numbers>

#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::fit::rub {
namespace {

using Complex = std::complex<double>;

constexpr int samples_per_turn = 256;

/// Displacements of the observed point in metres at equal shaft angles over the period. Empty where nothing
/// touches, where the motion repeats after fewer turns, or where the solver fails.
std::vector<Complex> sampled(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
                             integrate::exact::modes::ModeCache& modes, const Eigen::VectorXd& state,
                             int turns) {
  constexpr double same = 1e-6;
  const scene::Scene after = response::proof::after_the_kick(scene);
  std::vector<Complex> places_m;
  bool sooner = false;
  const auto record = response::motion::record_settled(
      after, solver, modes,
      {.start = {state.data(), static_cast<std::size_t>(state.size())},
       .turns = turns,
       .samples_per_revolution = samples_per_turn,
       .take = [&](const response::motion::RecordedTurn& turn) {
         const Eigen::Map<const Eigen::VectorXd> begin(turn.report.samples.data(), state.size());
         sooner = sooner || (turn.left < turns && (begin - state).norm() < same * state.norm());
         response::motion::add_samples(after, turn.report, places_m);
       }});
  return record && record->touched && !sooner ? places_m : std::vector<Complex>{};
}

/// Shaft angle at which a run of the scene begins. (The scene rotates the shaft's forces, so that a run
/// begins with the smallest gap.)
double shaft_angle_at_start_rad(const scene::PreparedMachine& machine, const scene::Cell& cell,
                                double speed_hz, double eccentricity_m) {
  const double speed_rad_per_s = 2 * std::numbers::pi * speed_hz;
  Eigen::VectorXcd force =
      eccentricity_m * speed_rad_per_s * speed_rad_per_s * machine.assembly.system.unbalance_kg;
  if (machine.assembly.bow_n.size() > 0) force += machine.assembly.bow_n;
  // Without forces at 1X, the force at 2X gives the angle up to half a turn, after which this force repeats.
  if (force.isZero(0) && machine.assembly.second_n.size() > 0)
    return std::arg(machine.assembly.second_n.dot(cell.scene.second_harmonic_n)) / 2;
  return std::arg(force.dot(cell.scene.harmonic_n));
}

Eigen::VectorXcd lines_of(const std::vector<Complex>& places_m, const std::vector<double>& orders,
                          double begin_rad) {
  Eigen::VectorXcd lines(static_cast<Eigen::Index>(orders.size()));
  const auto count = static_cast<double>(places_m.size());
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const double order = orders[i];
    Complex sum = 0;
    for (std::size_t k = 0; k < places_m.size(); ++k)
      sum += places_m[k] *
             std::polar(1.0, -2 * std::numbers::pi * order * static_cast<double>(k) / samples_per_turn);
    lines(static_cast<Eigen::Index>(i)) = sum / count * std::polar(1.0, -order * begin_rad);
  }
  return lines;
}

}  // namespace

struct RubOrbits::Orbit {
  Eigen::VectorXd section_m;
  std::vector<Complex> places_m;
  double begin_rad = 0;
};

RubOrbits::RubOrbits(integrate::run::SolverOptions solver, response::motion::ResponseOptions options)
    : solver_(std::move(solver)), options_(std::move(options)) {}

std::optional<Eigen::VectorXd> RubOrbits::followed_m(const RubLines& rub) const {
  const std::lock_guard lock(mutex_);
  const auto found = followed_m_.find({rub.speed_hz, rub.turns});
  return found == followed_m_.end() ? std::nullopt : std::optional(found->second);
}

RubOrbits::Orbit RubOrbits::orbit_of(const scene::PreparedMachine& machine, const RubLines& rub,
                                     double eccentricity_m) const {
  const scene::PreparedMachine there = scene::prepared_at(machine, rub.speed_hz);
  const scene::Cell cell = scene::build_cell(there, rub.speed_hz, scene::Eccentricity{eccentricity_m});
  response::motion::Workspace workspace;
  const branch::orbits::OrbitProblem problem = branch::orbits::scene_orbits(
      [&](double) { return std::optional(cell.scene); }, rub.turns, solver_, workspace.modes);
  Orbit orbit{.section_m = {},
              .places_m = {},
              .begin_rad = shaft_angle_at_start_rad(there, cell, rub.speed_hz, eccentricity_m)};
  const auto take = [&](const Eigen::VectorXd& near) {
    const auto found = branch::continuation::correct_at(problem, near, 0);
    if (!found.converged) return;
    orbit.section_m = found.point.state * cell.scene.length_scale_m;
    orbit.places_m = sampled(cell.scene, solver_, workspace.modes, found.point.state, rub.turns);
  };
  const Eigen::Index states = 2 * cell.scene.structure.coordinates();
  if (const auto near = followed_m(rub); near && near->size() == states)
    take(*near / cell.scene.length_scale_m);
  if (!orbit.places_m.empty()) return orbit;
  if (!scene::can_run(cell.start))
    throw ConfigError(
        fmt::format("rub: there is no motion at {} and an eccentricity of {:.6g} m, allowed: a "
                    "machine whose quiet whirl does not touch",
                    model::speed_text(rub.speed_hz), eccentricity_m));
  const branch::orbits::SettledStart start =
      branch::orbits::settle_on_orbit(cell, solver_, options_, workspace);
  if (start.order == rub.turns && start.closing == branch::orbits::Closing::with_the_shaft) take(start.state);
  if (orbit.places_m.empty())
    throw ConfigError(
        fmt::format("rub: at {} and an eccentricity of {:.6g} m the kick leads to a motion that "
                    "is {}{}, allowed: one in contact that repeats after {} turns as the recorded one",
                    model::speed_text(rub.speed_hz), eccentricity_m, to_string(start.motion_class),
                    start.order && *start.order > 1 ? fmt::format(" 1/{}", *start.order) : "", rub.turns));
  return orbit;
}

Eigen::VectorXcd RubOrbits::lines_m(const scene::PreparedMachine& machine, const RubLines& rub,
                                    double eccentricity_m) const {
  const Orbit orbit = orbit_of(machine, rub, eccentricity_m);
  return lines_of(orbit.places_m, rub.order, orbit.begin_rad);
}

void RubOrbits::follow(const scene::PreparedMachine& machine, const RubLines& rub, double eccentricity_m) {
  Orbit orbit = orbit_of(machine, rub, eccentricity_m);
  const std::lock_guard lock(mutex_);
  followed_m_.insert_or_assign({rub.speed_hz, rub.turns}, std::move(orbit.section_m));
}

}  // namespace rubsweep::fit::rub
