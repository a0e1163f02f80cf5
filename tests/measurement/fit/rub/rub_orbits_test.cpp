#include "rubsweep/measurement/fit/rub/rub_orbits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <future>
#include <numbers>

#include "core/scene/one_side_machine.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/measurement/fit/machine_fit.hpp"

namespace rubsweep::fit::rub {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double speed_hz = 70, eccentricity_m = 1.6e-4;
constexpr int turns = 2;

std::vector<double> half_orders() {
  std::vector<double> orders;
  for (int k = -6; k <= 6; ++k)
    if (k != 0) orders.push_back(0.5 * k);
  return orders;
}

RubLines asked() { return {.speed_hz = speed_hz, .turns = turns, .order = half_orders(), .line_m = {}}; }

/// Lines of the last turns of a long run from the kick, without Newton corrections.
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
                  std::polar(1.0, -2 * pi * order * static_cast<double>(k) / samples);
  }
  return lines;
}

/// Shaft angle at the start of a run, in closed form: the quiet whirl of the Jeffcott rotor points to the
/// wall, and the shaft leads by the lag of the response, arg(1 - r^2 + 2 i z r).
double begin_rad(const model::Machine& machine) {
  const auto& rotor = std::get<model::JeffcottRotor>(machine.rotor);
  const double r = speed_hz / rotor.natural_frequency_hz;
  return std::get<model::OneSideGeometry>(machine.stops.front().geometry).angle_deg * pi / 180 +
         std::arg(Complex(1 - r * r, 2 * rotor.damping_ratio * r));
}

/// Lines with phases that count from another mark, reached after a shaft angle of `angle_rad`.
Eigen::VectorXcd turned(Eigen::VectorXcd lines, double angle_rad) {
  for (Eigen::Index i = 0; i < lines.size(); ++i)
    lines(i) *= std::polar(1.0, half_orders()[static_cast<std::size_t>(i)] * angle_rad);
  return lines;
}

/// Largest difference of the lines. A period of two turns may begin with either turn; the smaller value is
/// returned.
double apart(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) {
  double least = INFINITY;
  for (int turn = 0; turn < turns; ++turn)
    least = std::min(least, (a - turned(b, 2 * pi * turn)).cwiseAbs().maxCoeff());
  return least;
}

TEST(RubOrbits, LinesAreThoseOfALongRun) {
  const scene::PreparedMachine machine = scene::prepare_machine(scene::one_side_machine());
  const Eigen::VectorXcd found = RubOrbits({}, {}).lines_m(machine, asked(), eccentricity_m);
  const Eigen::VectorXcd run = turned(lines_of_a_long_run(machine), -begin_rad(scene::one_side_machine()));
  EXPECT_GT(std::abs(run(6)), 1e-5) << "the motion is no 1/2";
  EXPECT_LT(apart(found, run), 1e-6 * run.norm());
  EXPECT_GT(apart(found, turned(run, 1e-3)), 1e-4 * run.norm()) << "phases count";
}

scene::PreparedMachine with_clearance(double factor) {
  model::Machine machine = scene::one_side_machine();
  machine.stops.front().clearance_m *= factor;
  return scene::prepare_machine(machine);
}

TEST(RubOrbits, ANextMachineIsReachedFromTheLastAsFromItsKick) {
  RubOrbits followed({}, {});
  followed.follow(with_clearance(1), asked(), eccentricity_m);
  const Eigen::VectorXcd far = RubOrbits({}, {}).lines_m(with_clearance(1.01), asked(), eccentricity_m);
  EXPECT_LT(apart(followed.lines_m(with_clearance(1.01), asked(), eccentricity_m), far), 1e-8 * far.norm());
}

TEST(RubOrbits, LinesDoNotDependOnWhoElseAsked) {
  RubOrbits one({}, {}), other({}, {});
  RubLines faster = asked();
  faster.speed_hz = 71;
  one.follow(with_clearance(1), asked(), eccentricity_m);
  one.follow(with_clearance(1), faster, eccentricity_m);
  other.follow(with_clearance(1), faster, eccentricity_m);
  other.follow(with_clearance(1), asked(), eccentricity_m);
  const Eigen::VectorXcd first = one.lines_m(with_clearance(1.001), asked(), eccentricity_m),
                         second = one.lines_m(with_clearance(0.999), asked(), eccentricity_m),
                         other_speed = one.lines_m(with_clearance(1.001), faster, eccentricity_m);
  EXPECT_EQ(other.lines_m(with_clearance(1.001), faster, eccentricity_m), other_speed);
  EXPECT_EQ(other.lines_m(with_clearance(0.999), asked(), eccentricity_m), second);
  EXPECT_EQ(other.lines_m(with_clearance(1.001), asked(), eccentricity_m), first);
  // The lines do not depend on a call from a second thread.
  auto beside = std::async(std::launch::async,
                           [&] { return one.lines_m(with_clearance(1.001), asked(), eccentricity_m); });
  EXPECT_EQ(one.lines_m(with_clearance(0.999), asked(), eccentricity_m), second);
  EXPECT_EQ(beside.get(), first);
}

TEST(RubOrbits, RefusesAMotionThatRepeatsSooner) {
  RubLines twice = asked();
  twice.turns = 2 * turns;
  RubOrbits orbits({}, {});
  const std::string message =
      message_of<ConfigError>([&] { orbits.lines_m(with_clearance(1), twice, eccentricity_m); });
  EXPECT_NE(
      message.find("a motion that is subharmonic 1/2, allowed: one in contact that repeats after 4 turns"),
      std::string::npos)
      << message;
}

TEST(RubOrbits, RefusesAMachineThatDoesNotRub) {
  model::Machine quiet = scene::one_side_machine();
  quiet.kick.reset();
  RubOrbits orbits({}, {});
  EXPECT_THROW(orbits.lines_m(scene::prepare_machine(quiet), asked(), eccentricity_m), ConfigError);
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
  // The long run begins at its own smallest gap, so its lines are rotated to the shaft's zero angle, then to
  // another mark.
  data.line_m = turned(data.line_m, mark_deg * pi / 180 - begin_rad(scene::one_side_machine()));
  RubOrbits orbits({}, {});
  MachineFit problem{.parameters = {{"clearance", 1e-3, 9e-4, 1.2e-3, 1e-3},
                                    {"stiffness", 2e6, 1e6, 4e6, 2e6},
                                    {eccentricity_name, 1.5e-4, 1e-5, 1e-3, 1e-4},
                                    {mark_name, 0, -180, 180, 30}},
                     .data = {{"rub", data, false}},
                     .machine = [&](const Eigen::VectorXd& at) { return with(at(0), at(1)); },
                     .rub_lines = [&](const scene::PreparedMachine& machine, const RubLines& rub,
                                      double e) { return orbits.lines_m(machine, rub, e); },
                     .follow_rub = [&](const scene::PreparedMachine& machine, const RubLines& rub,
                                       double e) { orbits.follow(machine, rub, e); }};
  const MachineFitResult result = fit_machine(problem, {});
  EXPECT_TRUE(result.fit.converged);
  EXPECT_NEAR(result.fit.value(0), clearance_m, 1e-5 * clearance_m);
  EXPECT_NEAR(result.fit.value(1), stiffness, 1e-4 * stiffness);
  EXPECT_NEAR(result.fit.value(2), eccentricity_m, 1e-4 * eccentricity_m);
  EXPECT_NEAR(result.fit.value(3), mark_deg, 1e-2);
}

}  // namespace
}  // namespace rubsweep::fit::rub
