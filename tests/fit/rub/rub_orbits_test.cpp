#include "rubsweep/fit/rub/rub_orbits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/error.hpp"
#include "rubsweep/fit/machine_fit.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/response/motion/workspace.hpp"
#include "scene/one_side_machine.hpp"

namespace rubsweep::fit::rub {
namespace {

using Complex = std::complex<double>;

constexpr double speed_hz = 70, eccentricity_m = 1.6e-4;
constexpr int turns = 2;

std::vector<double> half_orders() {
  std::vector<double> orders;
  for (int k = -6; k <= 6; ++k)
    if (k != 0) orders.push_back(0.5 * k);
  return orders;
}

AskedLines asked() { return {speed_hz, eccentricity_m, turns, half_orders()}; }

/// Lines of the last turns of a long run from the kick, with which no orbit is corrected.
Eigen::VectorXcd lines_of_a_long_run(const scene::PreparedMachine& machine) {
  constexpr int long_enough = 1200, samples = 512;
  const scene::Cell cell = scene::build_cell(machine, speed_hz, scene::Eccentricity{eccentricity_m});
  response::motion::Workspace workspace;
  const integrate::run::Run run = integrate::start(cell.scene, {}, workspace.modes);
  integrate::run::TurnRequest request;
  integrate::run::TurnReport report;
  std::vector<Complex> places_m;
  const auto& observed = cell.scene.structure.points[static_cast<std::size_t>(cell.scene.observed_point)].map;
  for (int turn = 0; turn < long_enough + turns; ++turn) {
    request.samples_per_revolution = turn < long_enough ? 0 : samples;
    EXPECT_EQ(run.advance(request, report), integrate::run::Outcome::ok);
    const Eigen::Index states = 2 * cell.scene.structure.coordinates();
    for (int k = 0; k < (turn < long_enough ? 0 : samples); ++k) {
      const Eigen::Map<const Eigen::VectorXd> state(report.samples.data() + k * states, states);
      const Eigen::Vector2d place = cell.scene.length_scale_m * (observed * state.head(states / 2));
      places_m.emplace_back(place.x(), place.y());
    }
  }
  Eigen::VectorXcd lines(12);
  for (Eigen::Index i = 0; i < lines.size(); ++i) {
    const double order = half_orders()[static_cast<std::size_t>(i)];
    lines(i) = 0;
    for (std::size_t k = 0; k < places_m.size(); ++k)
      lines(i) += places_m[k] / static_cast<double>(places_m.size()) *
                  std::polar(1.0, -2 * std::numbers::pi * order * static_cast<double>(k) / samples);
  }
  return lines;
}

TEST(RubOrbits, LinesAreThoseOfALongRun) {
  const scene::PreparedMachine machine = scene::prepare_machine(scene::one_side_machine());
  RubOrbits orbits({}, {});
  const Eigen::VectorXcd found = orbits.lines_m(machine, asked());
  const Eigen::VectorXcd run = lines_of_a_long_run(machine);
  EXPECT_GT(std::abs(run(6)), 1e-5) << "the motion is no 1/2";
  for (Eigen::Index i = 0; i < run.size(); ++i)
    EXPECT_NEAR(std::abs(found(i)), std::abs(run(i)), 1e-6 * run.norm())
        << half_orders()[static_cast<std::size_t>(i)];
  // Both begin elsewhere on the turn: one angle, a whole number of turns apart, explains all phases.
  double least = INFINITY;
  for (int turn = 0; turn < turns; ++turn) {
    const double angle = std::arg(found(7) / run(7)) + 2 * std::numbers::pi * turn;
    double most = 0;
    for (Eigen::Index i = 0; i < run.size(); ++i)
      most = std::max(
          most,
          std::abs(found(i) - run(i) * std::polar(1.0, half_orders()[static_cast<std::size_t>(i)] * angle)));
    least = std::min(least, most);
  }
  EXPECT_LT(least, 1e-6 * run.norm());
}

TEST(RubOrbits, ANextMachineIsReachedFromTheLastAsFromItsKick) {
  model::Machine other = scene::one_side_machine();
  other.stops.front().clearance_m *= 1.01;
  RubOrbits followed({}, {}), alone({}, {});
  followed.lines_m(scene::prepare_machine(scene::one_side_machine()), asked());
  const Eigen::VectorXcd near = followed.lines_m(scene::prepare_machine(other), asked());
  const Eigen::VectorXcd far = alone.lines_m(scene::prepare_machine(other), asked());
  double least = INFINITY;
  for (int turn = 0; turn < turns; ++turn) {
    double most = 0;
    for (Eigen::Index i = 0; i < far.size(); ++i)
      most = std::max(
          most, std::abs(near(i) - far(i) * std::polar(1.0, 2 * std::numbers::pi * turn *
                                                                half_orders()[static_cast<std::size_t>(i)])));
    least = std::min(least, most);
  }
  EXPECT_LT(least, 1e-8 * far.norm());
}

TEST(RubOrbits, RefusesAMachineThatDoesNotRub) {
  model::Machine quiet = scene::one_side_machine();
  quiet.kick.reset();
  RubOrbits orbits({}, {});
  EXPECT_THROW(orbits.lines_m(scene::prepare_machine(quiet), asked()), ConfigError);
}

TEST(RubOrbits, AFitFindsWhatTheStopIs) {
  constexpr double clearance_m = 1.03e-3, stiffness = 1.9e6, mark_deg = 40;
  const auto with = [](double clearance, double stop_stiffness) {
    model::Machine machine = scene::one_side_machine();
    machine.stops.front().clearance_m = clearance;
    machine.stops.front().stiffness_n_per_m = stop_stiffness;
    return scene::prepare_machine(machine);
  };
  RubLines data{.speed_hz = speed_hz, .turns = turns, .order = half_orders(), .line_m = {}};
  data.line_m = lines_of_a_long_run(with(clearance_m, stiffness));
  // The long run begins where its own smallest gap is: its lines are turned to the shaft, then to another
  // mark.
  RubOrbits truth({}, {});
  const Eigen::VectorXcd shaft = truth.lines_m(with(clearance_m, stiffness), asked());
  for (Eigen::Index i = 0; i < shaft.size(); ++i)
    data.line_m(i) =
        std::polar(std::abs(data.line_m(i)), std::arg(shaft(i))) *
        std::polar(1.0, data.order[static_cast<std::size_t>(i)] * mark_deg * std::numbers::pi / 180);
  RubOrbits orbits({}, {});
  MachineFit problem{.parameters = {{"clearance", 1e-3, 9e-4, 1.2e-3, 1e-3},
                                    {"stiffness", 2e6, 1e6, 4e6, 2e6},
                                    {eccentricity_name, 1.5e-4, 1e-5, 1e-3, 1e-4},
                                    {mark_name, 0, -180, 180, 30}},
                     .data = {{"rub", data, false}},
                     .machine = [&](const Eigen::VectorXd& at) { return with(at(0), at(1)); },
                     .rub_lines =
                         [&](const scene::PreparedMachine& machine, const RubLines& rub, double e) {
                           return orbits.lines_m(machine, {rub.speed_hz, e, rub.turns, rub.order});
                         }};
  const MachineFitResult result = fit_machine(problem, {});
  EXPECT_TRUE(result.fit.converged);
  EXPECT_NEAR(result.fit.value(0), clearance_m, 1e-5 * clearance_m);
  EXPECT_NEAR(result.fit.value(1), stiffness, 1e-4 * stiffness);
  EXPECT_NEAR(result.fit.value(2), eccentricity_m, 1e-4 * eccentricity_m);
  EXPECT_NEAR(result.fit.value(3), mark_deg, 1e-2);
}

}  // namespace
}  // namespace rubsweep::fit::rub
