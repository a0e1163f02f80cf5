#include "rubsweep/analysis/ramp/ramp_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "analysis/line/line_of_cells.hpp"
#include "analysis/ramp/ring_machine.hpp"
#include "core/scene/kit_machine.hpp"
#include "core/scene/misaligned_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/linear/experiment.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/contact/force_law.hpp"
#include "rubsweep/core/error.hpp"
#include "rubtrace/ramp_record.hpp"

namespace rubsweep::ramp {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
using integrate::run::Outcome;

/// Collects all samples of a ramp.
std::vector<RampSample> samples_of(const model::Machine& machine, const SpeedRamp& ramp,
                                   const integrate::run::SolverOptions& solver = {
                                       .relative_tolerance = 1e-10}) {
  std::vector<RampSample> samples;
  const Outcome outcome =
      run_ramp(scene::prepare_machine(machine), ramp, solver, 32, [&](const RampStretch& stretch) {
        samples.insert(samples.end(), stretch.samples.begin(), stretch.samples.end());
      });
  EXPECT_EQ(outcome, Outcome::ok);
  return samples;
}

/// A Jeffcott rotor far inside an annular stop, without contact.
model::Machine roomy_machine(double damping_ratio) {
  model::Machine machine;
  machine.rotor =
      model::JeffcottRotor{.mass_kg = 5, .natural_frequency_hz = 100, .damping_ratio = damping_ratio};
  model::Stop stop;
  stop.geometry = model::AnnularGeometry{};
  stop.clearance_m = 0.1;
  stop.stiffness_n_per_m = 1e7;
  stop.damping = model::NominalRestitution{0.5};
  stop.contact_radius_m = 0.2;
  machine.stops = {stop};
  return machine;
}

TEST(RampRun, LargestOneXIsTheLargestRadiusOfACircularMotion) {
  // Reference values of an independent solver, such as 0.01147795 m at 102.573 Hz for the first case.
  struct Case {
    double damping_ratio;
    SpeedRamp ramp;
  };
  for (const auto& [damping_ratio, ramp] :
       {Case{0.02, {5, 150, 24.1667, 5e-4}}, Case{0.02, {5, 150, 60, 5e-4}},
        Case{0.01, {160, 60, -35, 5e-4}}}) {
    const model::Machine machine = roomy_machine(damping_ratio);
    double peak_m = 0;
    run_ramp(scene::prepare_machine(machine), ramp, {.relative_tolerance = 1e-10}, 32,
             [&](const RampStretch& stretch) { peak_m = std::max(peak_m, stretch.peak_displacement_m); });
    const linear::RunUp found = linear::run_up(scene::prepare_machine(machine), ramp.from_hz, ramp.to_hz,
                                               ramp.rate_hz_per_s, ramp.eccentricity_m, {});
    for (const double amplitude_m : found.largest_amplitude_m)
      EXPECT_NEAR(amplitude_m, peak_m, 2e-6 * peak_m) << ramp.rate_hz_per_s;
    if (ramp.rate_hz_per_s != 24.1667) continue;
    EXPECT_NEAR(found.largest_amplitude_m[0], 0.01147795, 5e-8);
    ASSERT_TRUE(found.speed_of_largest_1x_hz[1]);
    EXPECT_NEAR(*found.speed_of_largest_1x_hz[1], 102.573, 1e-3);
  }
}

/// Expects a ramp far from the stops to agree with linear::run_linear, which uses other equations and units.
void expect_as_without_stops(model::Machine machine, const SpeedRamp& ramp) {
  machine.kick.reset();
  machine.stops.front().clearance_m = 4e-3;
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  const auto samples = samples_of(machine, ramp);
  const linear::LinearRun linear{.from_hz = ramp.from_hz,
                                 .rate_hz_per_s = ramp.rate_hz_per_s,
                                 .eccentricity_m = ramp.eccentricity_m,
                                 .sample_s = samples[1].t_s,
                                 .samples = static_cast<int>(samples.size())};
  const auto& observed =
      prepared.assembly.system.points[static_cast<std::size_t>(prepared.assembly.observed_point)].map;
  const Eigen::MatrixXd expected = linear::run_linear(prepared, linear, observed);
  double largest = 0, difference = 0;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const Eigen::Vector2d z = expected.row(static_cast<Eigen::Index>(k)).transpose();
    largest = std::max(largest, z.norm());
    difference = std::max(difference, (samples[k].displacement_m - z).norm());
  }
  EXPECT_GT(largest, 1e-4);
  EXPECT_LT(largest, 3e-3);
  EXPECT_LT(difference, 2e-5 * largest);
}

TEST(RampRun, FarFromTheStopsIsThatWithoutStops) {
  expect_as_without_stops(scene::one_side_machine(), {20, 40, 10, 5e-5});
  expect_as_without_stops(scene::one_side_machine(), {40, 20, -10, 5e-5});
}

TEST(RampRun, FromRestIsThatWithoutStops) {
  model::Machine machine = scene::one_side_machine();
  machine.start = {.at_rest = true};
  machine.gravity_m_per_s2 = 9.81;
  expect_as_without_stops(machine, {20, 40, 10, 5e-5});
  machine = scene::table_machine();
  machine.start = {.at_rest = true};
  expect_as_without_stops(machine, {30, 110, 40, 4e-4});
}

TEST(RampRun, WithAMisalignedCouplingIsThatWithoutStops) {
  expect_as_without_stops(scene::MisalignedRotor{}.machine(), {12, 28, 8, 2e-5});
}

TEST(RampRun, WithDampingThatTurnsIsThatWithoutStops) {
  model::Machine machine = scene::one_side_machine();
  std::get<model::JeffcottRotor>(machine.rotor).rotating_damping_ratio = 0.01;
  expect_as_without_stops(machine, {20, 40, 10, 5e-5});
}

TEST(RampRun, SupportsFollowTheirTablesAsWithoutStops) {
  expect_as_without_stops(scene::table_machine(), {30, 110, 40, 4e-4});
  expect_as_without_stops(scene::table_machine(), {120, 20, -40, 4e-4});
}

TEST(RampRun, EndsOfATableAndChangingMassesAreRefused) {
  const auto ignore = [](const RampStretch&) {};
  model::Machine machine = scene::table_machine();
  EXPECT_THROW(run_ramp(scene::prepare_machine(machine), {19, 30, 10, 1e-5}, {}, 32, ignore), ConfigError);
  model::kit_of(machine)->supports[0].table->columns[8] = {0, 0.01, 0.02, 0.03, 0.04};
  EXPECT_THROW(run_ramp(scene::prepare_machine(machine), {20, 30, 10, 1e-5}, {}, 32, ignore), ConfigError);
}

TEST(RampRun, OfAGyroscopicBowedKitIsThatWithoutStops) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.discs.front().position_m = 0.13;  // away from midspan, so that the disc tilts
  kit.shaft.front().density_kg_per_m3 = 7850;
  kit.modes = 2;
  kit.bow = model::Bow{model::BowMode{.mode = 1, .amplitude_m = 5e-5}, 30};
  expect_as_without_stops(machine, {20, 45, 10, 3e-5});
}

/// The same machine by the classical Runge-Kutta method with small steps and a separately written contact
/// law: z of rotor and casing.
std::vector<Complex> reference(const SpeedRamp& ramp, double sample_s, std::size_t count) {
  constexpr double m = 0.8, casing_m = 0.05, casing_k = 5e5, stiffness = 2e6, clearance = 1e-3,
                   radius = 0.0375;
  const double w0 = 2 * pi * 30, c = 2 * 0.02 * w0 * m, k = m * w0 * w0;
  const double casing_c = 2 * 0.1 * std::sqrt(casing_k * casing_m);
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  const scene::Cell cell =
      scene::build_cell(prepared, ramp.from_hz, scene::Eccentricity{ramp.eccentricity_m});
  const double damping = cell.scene.contacts.front().damping_ns_per_m;
  struct State {
    Complex z, v, y, u;
  };
  const auto rate = [&](double t, const State& s) {
    const double w = 2 * pi * ramp.speed_hz(t), a = 2 * pi * ramp.rate_hz_per_s;
    const double p = (s.z - s.y).imag() - clearance, closing = (s.v - s.u).imag();
    const contact::NormalForce normal = contact::elastogap(stiffness, damping, p, closing);
    // The tangent of a wall above the rotor points to -x.
    const double slip = -(s.v - s.u).real() + radius * w;
    const double friction = 0.1 * std::tanh(100 * slip) * normal.spring_n;
    const Complex on_casing = Complex(-friction, normal.total_n);
    const Complex unbalance =
        m * ramp.eccentricity_m * Complex(w * w, -a) * std::polar(1.0, ramp.angle_rad(t));
    return State{s.v, (unbalance - c * s.v - k * s.z - on_casing) / m, s.u,
                 (on_casing - casing_c * s.u - casing_k * s.y) / casing_m};
  };
  const auto moved = [](const State& s, double h, const State& r) {
    return State{s.z + h * r.z, s.v + h * r.v, s.y + h * r.y, s.u + h * r.u};
  };
  State s{{0, 0}, {0, 0}, {0, 0}, {0, 0}};  // the quiet motion would reach the wall, so it starts at rest
  EXPECT_EQ(cell.start, scene::Start::contact);
  std::vector<Complex> samples;
  constexpr int steps = 400;
  const double h = sample_s / steps;
  for (std::size_t n = 0; n < count; ++n) {
    samples.push_back(s.z);
    for (int i = 0; i < steps; ++i) {
      const double t = static_cast<double>(n) * sample_s + i * h;
      const State a = rate(t, s), b = rate(t + h / 2, moved(s, h / 2, a)),
                  d = rate(t + h / 2, moved(s, h / 2, b)), e = rate(t + h, moved(s, h, d));
      s = moved(moved(moved(moved(s, h / 6, a), h / 3, b), h / 3, d), h / 6, e);
    }
  }
  return samples;
}

TEST(RampRun, ThroughImpactsIsThatOfSmallFixedSteps) {
  const SpeedRamp ramp{28, 34, 10, 2e-4};
  const auto samples = samples_of(scene::one_side_machine(), ramp);
  // The comparison ends before impacts amplify rounding.
  const std::size_t count = samples.size() / 2;
  const auto expected = reference(ramp, samples[1].t_s, count);
  double largest = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Complex z(samples[k].displacement_m.x(), samples[k].displacement_m.y());
    largest = std::max(largest, std::abs(z));
    ASSERT_NEAR(std::abs(z - expected[k]), 0, 2e-5 * 1e-3) << k;
  }
  EXPECT_GT(largest, 1.2e-3);  // the rotor reached the wall
}

TEST(RampRun, ASlowOneFollowsTheQuasiStaticMotionAndRubsWhereThatDoes) {
  constexpr double eccentricity_m = 2e-4;
  std::vector<double> speeds_hz;
  for (double speed_hz = 24; speed_hz <= 42; speed_hz += 0.5) speeds_hz.push_back(speed_hz);
  const auto cells = line::over_speed(ring_machine(), speeds_hz, scene::Eccentricity{eccentricity_m});
  const auto points = line::followed(cells, {line::Pass::up, line::Pass::down});
  for (const bool up : {true, false}) {
    const SpeedRamp ramp =
        up ? SpeedRamp{24, 42, 0.5, eccentricity_m} : SpeedRamp{42, 24, -0.5, eccentricity_m};
    RampRecord record(ramp);
    ASSERT_EQ(run_ramp(scene::prepare_machine(ring_machine()), ramp, {}, 32,
                       [&](const RampStretch& stretch) { record.add(stretch); }),
              Outcome::ok);
    double first_hz = 0, last_hz = 0;
    int compared = 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const line::LinePoint& point = points[up ? i : cells.size() + i];
      const double radius_m = point.motion->section.front().displacement_m.norm();
      if (radius_m > 1e-3) {
        if (first_hz == 0) first_hz = cells[i].value;
        last_hz = cells[i].value;
      }
      for (const EnvelopePoint& at : record.envelope()) {
        // Speeds are left out where the ramp has just reached the wall and still vibrates, or where it jumps.
        const double jump_hz = up ? 27.8 : 33;
        if (std::abs(at.speed_hz - cells[i].value) > 0.02 || std::abs(at.speed_hz - jump_hz) < 1.5) continue;
        ++compared;
        EXPECT_NEAR(at.peak_displacement_m, radius_m, 0.03 * radius_m)
            << at.speed_hz << (up ? " up" : " down");
      }
    }
    EXPECT_GT(compared, 15);
    const auto spans = record.rubbing_spans();
    ASSERT_EQ(spans.size(), 1u);
    // On the way up the rub begins at the wall and never ends. On the way down it begins at the upper touch
    // speed and ends at the lower one.
    EXPECT_NEAR(up ? spans[0].from_hz : spans[0].to_hz, first_hz, 1.0);
    EXPECT_NEAR(up ? spans[0].to_hz : spans[0].from_hz, last_hz, 1.0);
  }
}

TEST(RampRun, WhatNoRampIsMadeOfIsRefused) {
  model::Machine machine = scene::light_shaft_machine();
  std::get<model::RotorKit>(machine.rotor).supports.front().fault =
      model::BearingFault{.impulse_ns = 1e-3, .multiple = 1};
  EXPECT_THROW(
      run_ramp(scene::prepare_machine(machine), {20, 40, 10, 1e-5}, {}, 32, [](const RampStretch&) {}),
      ConfigError);
  // An undamped resonance has no quiet motion to start from.
  machine = scene::one_side_machine();
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0};
  EXPECT_THROW(
      run_ramp(scene::prepare_machine(machine), {30, 40, 10, 1e-5}, {}, 32, [](const RampStretch&) {}),
      ConfigError);
}

TEST(RampRun, AngleIsQuadraticAndTimeItsInverse) {
  for (const SpeedRamp& ramp : {SpeedRamp{10, 60, 2, 0}, SpeedRamp{60, 10, -2, 0}}) {
    EXPECT_DOUBLE_EQ(ramp.duration_s(), 25);
    EXPECT_DOUBLE_EQ(ramp.speed_hz(25), ramp.to_hz);
    // The total angle is the mean speed times the duration.
    EXPECT_NEAR(ramp.angle_rad(25), 2 * std::numbers::pi * 35 * 25, 1e-9);
    for (const double t_s : {0.0, 0.3, 11.0, 24.9})
      EXPECT_NEAR(ramp.time_s(ramp.angle_rad(t_s) / (2 * std::numbers::pi)), t_s, 1e-11);
  }
}

}  // namespace
}  // namespace rubsweep::ramp
