#include "rubsweep/core/response/settle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/response/annular_cell.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::response {
namespace {

SettledRun run(const test::OneSideRotor& rotor, const motion::ResponseOptions& options,
               const integrate::run::SolverOptions& solver = {}) {
  const auto cell = test::cell_of(rotor);
  motion::Workspace workspace;
  return settle(cell, solver, options, workspace);
}

motion::ResponseOptions without_floquet_proof() {
  motion::ResponseOptions options;
  options.floquet_proof = false;
  return options;
}

TEST(Settle, TheHalfSubharmonicOfSetAIsProven) {
  const auto proven = run({}, {}), observed = run({}, without_floquet_proof());
  EXPECT_EQ(proven.proof, motion::Proof::floquet);
  EXPECT_EQ(proven.motion.order, 2);
  EXPECT_LT(proven.revolutions, 100);
  // Only the rotor's damper damps its tangential motion: e^{-zeta w0 2T} over two turns.
  const double decay = 0.02 * 2 * std::numbers::pi * 30 * 2 / 75;
  EXPECT_NEAR(proven.floquet_modulus.value(), std::exp(-decay), 1e-9);
  const motion::Measures &a = proven.motion.measures, &b = observed.motion.measures;
  EXPECT_EQ(a.turns, 2);
  EXPECT_EQ(a.contact.hits * b.turns, b.contact.hits * a.turns);
  EXPECT_NEAR(a.amplitude_1x_forward_m, b.amplitude_1x_forward_m, 1e-12);
  EXPECT_NEAR(a.contact.peak_contact_force_n, b.contact.peak_contact_force_n, 1e-6);
  EXPECT_EQ(a.dominant.value().order, b.dominant.value().order);
  EXPECT_EQ(a.orbit, b.orbit);
}

TEST(Settle, BothSolversProveTheSameOrbit) {
  integrate::run::SolverOptions adaptive;
  adaptive.method = integrate::run::Method::adaptive;
  const auto a = run({}, {}), b = run({}, {}, adaptive);
  EXPECT_EQ(b.proof, motion::Proof::floquet_observed);
  EXPECT_EQ(b.motion.order, 2);
  EXPECT_NEAR(a.floquet_modulus.value(), b.floquet_modulus.value(), 1e-4);
  EXPECT_NEAR(a.motion.measures.amplitude_1x_forward_m, b.motion.measures.amplitude_1x_forward_m, 1e-12);
}

/// The rotor with other units of time, length and mass.
test::OneSideRotor in_units(test::OneSideRotor rotor, double time, double length, double mass) {
  const double stiffness = mass / (time * time), force = stiffness * length;
  for (double* x : {&rotor.mass_kg, &rotor.casing_mass_kg}) *x *= mass;
  for (double* x : {&rotor.stiffness_n_per_m, &rotor.casing_stiffness_n_per_m}) *x *= stiffness;
  for (double* x : {&rotor.clearance_m, &rotor.contact_radius_m}) *x *= length;
  for (double* x : {&rotor.natural_frequency_hz, &rotor.speed_hz}) *x /= time;
  rotor.friction_steepness_s_per_m *= time / length;
  rotor.kick_n *= force;
  rotor.kick_s *= time;
  return rotor;
}

/// No constant in a solver has the unit of seconds, metres or kilograms.
TEST(Settle, UnitsOfTimeLengthAndMassAreNoMatter) {
  for (const double speed_hz : {50.0, 75.0, 110.0}) {
    for (const double whirl_ratio : {0.2, 0.6}) {
      test::OneSideRotor rotor;
      rotor.speed_hz = speed_hz;
      rotor.whirl_ratio = whirl_ratio;
      const auto a = run(rotor, {});
      for (const auto& [time, length, mass] :
           {std::array{0x1p-20, 1.0, 1.0}, std::array{0x1p12, 0x1p-20, 0x1p10},
            std::array{0x1p-8, 0x1p9, 0x1p-30}}) {
        const auto b = run(in_units(rotor, time, length, mass), {});
        EXPECT_EQ(b.motion.motion_class, a.motion.motion_class);
        EXPECT_EQ(b.motion.order, a.motion.order);
        EXPECT_EQ(b.proof, a.proof);
        EXPECT_EQ(b.revolutions, a.revolutions);
        // Rounding differs, and a long transient amplifies it.
        EXPECT_NEAR(static_cast<double>(b.last_contact_revolution.value_or(0)),
                    static_cast<double>(a.last_contact_revolution.value_or(0)), 2);
        const double peak_m = a.motion.measures.contact.peak_displacement_m,
                     peak_n = a.motion.measures.contact.peak_contact_force_n,
                     force = mass * length / (time * time);
        EXPECT_NEAR(b.motion.measures.contact.peak_displacement_m, length * peak_m, 1e-11 * length * peak_m);
        EXPECT_NEAR(b.motion.measures.contact.peak_contact_force_n, force * peak_n, 1e-9 * force * peak_n);
      }
    }
  }
}

SettledRun run_struck(double multiple, const motion::ResponseOptions& options) {
  auto cell = test::cell_of({});
  cell.scene.impulses.push_back({0.005 * Eigen::Vector4d(1, 1, 0, 0), multiple, 0.2});
  motion::Workspace workspace;
  return settle(cell, {}, options, workspace);
}

TEST(Settle, ImpulsesThatRepeatEveryTurnLeaveTheProof) {
  const auto proven = run_struck(2, {}), observed = run_struck(2, without_floquet_proof());
  EXPECT_EQ(proven.proof, motion::Proof::floquet_observed);
  EXPECT_EQ(observed.proof, motion::Proof::observed);
  EXPECT_EQ(proven.motion.order, 2);
  EXPECT_EQ(observed.motion.order, 2);
  EXPECT_NEAR(proven.motion.measures.amplitude_1x_forward_m, observed.motion.measures.amplitude_1x_forward_m,
              1e-12);
  EXPECT_GT(std::abs(proven.motion.measures.amplitude_1x_forward_m -
                     run({}, {}).motion.measures.amplitude_1x_forward_m),
            1e-9);
}

/// With 2.5 impulses per turn the impulses repeat after two turns, with 1 / 3 of an impulse per turn after
/// three turns. Consecutive turns differ.
TEST(Settle, OtherImpulsesOnlyLetTheMotionBeObserved) {
  for (const auto& [multiple, order] : {std::pair{2.5, 2}, std::pair{1.0 / 3, 6}}) {
    const auto settled = run_struck(multiple, {});
    EXPECT_EQ(settled.proof, motion::Proof::observed);
    EXPECT_EQ(settled.revolutions, 600);
    EXPECT_EQ(settled.motion.motion_class, motion::MotionClass::subharmonic);
    EXPECT_EQ(settled.motion.order, order);
  }
  const auto never = run_struck(std::numbers::phi, {});
  EXPECT_EQ(never.motion.motion_class, motion::MotionClass::unsettled);
  EXPECT_FALSE(never.motion.exponent);
}

TEST(Settle, TheHalfSubharmonicOfSetA) {
  const auto settled = run({}, without_floquet_proof());
  EXPECT_EQ(settled.motion.motion_class, motion::MotionClass::subharmonic);
  EXPECT_EQ(settled.motion.order, 2);
  EXPECT_EQ(settled.proof, motion::Proof::observed);
  EXPECT_EQ(settled.revolutions, 600);
  EXPECT_GE(settled.last_contact_revolution.value_or(0), 599);  // impacts in every second turn, to the end
  const motion::Measures& measures = settled.motion.measures;
  EXPECT_EQ(measures.contact.hits, measures.turns / 2);
  EXPECT_NEAR(std::abs(measures.dominant.value().order), 0.5, 1e-12);
  // The peak is at the wall plus the penetration; the motion on the far side is free.
  EXPECT_GT(measures.contact.peak_displacement_m, 1e-3);
  EXPECT_GT(measures.contact.peak_contact_force_n, 10);
}

TEST(Settle, LabelDoesNotDependOnTheStepper) {
  for (const auto stepper : integrate::adaptive::single_steppers()) {
    integrate::run::SolverOptions solver;
    solver.stepper = stepper;
    if (stepper == integrate::run::Stepper::rosenbrock4) solver.relative_tolerance = 1e-6;
    const auto settled = run({}, {}, solver);
    EXPECT_EQ(settled.motion.order, 2) << integrate::adaptive::row_of(stepper).word;
  }
}

TEST(Settle, AWeakKickIsProvenToRestInTheClosedFormCircle) {
  test::OneSideRotor rotor;
  rotor.kick_n = 1;
  const auto settled = run(rotor, {});
  EXPECT_EQ(settled.motion.motion_class, motion::MotionClass::non_contact);
  EXPECT_EQ(settled.proof, motion::Proof::rest);
  EXPECT_FALSE(settled.last_contact_revolution);
  EXPECT_LT(settled.revolutions, 20);
  EXPECT_NEAR(settled.motion.measures.amplitude_1x_forward_m, rotor.whirl_ratio * rotor.clearance_m, 1e-15);
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(settled.motion.measures.whirl, spectrum::WhirlKind::forward);
  EXPECT_NEAR(settled.motion.measures.contact.peak_displacement_m, rotor.whirl_ratio * rotor.clearance_m,
              1e-15);
}

/// Runs 600 turns without a proof and expects the quiet motion.
void expect_quiet_long_run(const test::OneSideRotor& rotor) {
  const auto cell = test::cell_of(rotor);
  motion::Workspace workspace;
  const auto motion = integrate::start(cell.scene, {}, workspace.modes);
  integrate::run::TurnReport turn;
  int last_touch = 0;
  for (int k = 1; k <= 600; ++k) {
    ASSERT_EQ(motion.advance({}, turn), integrate::run::Outcome::ok);
    if (turn.touched) last_touch = k;
  }
  EXPECT_LT(last_touch, 300);
  EXPECT_NEAR(std::hypot(turn.section[0], turn.section[1]), rotor.whirl_ratio, 1e-5);
}

TEST(Settle, ProvenRestIsWhatALongRunShows) {
  test::OneSideRotor rotor;
  rotor.whirl_ratio = 0.05;
  const auto proven = run(rotor, {});
  EXPECT_EQ(proven.proof, motion::Proof::rest);
  rotor.casing_damping_ratio = 1;  // equal natural frequencies are allowed
  EXPECT_EQ(run(rotor, {}).proof, motion::Proof::rest);
  expect_quiet_long_run(rotor);
}

TEST(Settle, FailuresNameTheirOutcome) {
  integrate::run::SolverOptions solver;
  solver.max_steps_per_revolution = 10;
  const auto settled = run({}, {}, solver);
  EXPECT_EQ(settled.motion.motion_class, motion::MotionClass::failed);
  EXPECT_EQ(settled.outcome, integrate::run::Outcome::step_limit);
  EXPECT_FALSE(settled.proof);
}

/// A rotor in a soft undamped ring: its chaotic transients last for a thousand turns before an oval motion.
scene::Cell cell_of_long_transients(double eccentricity_m) {
  model::Stop ring;
  ring.geometry = model::AnnularGeometry{{0, 0}};
  ring.clearance_m = 1;
  ring.stiffness_n_per_m = 50;
  ring.damping = model::ExplicitDamping{0};
  ring.contact_radius_m = 2;
  model::Machine machine;
  machine.rotor =
      model::JeffcottRotor{.mass_kg = 10, .natural_frequency_hz = 0.0503, .damping_ratio = 0.0079};
  machine.stops = {ring};
  scene::Cell cell = scene::build_cell(machine, 0.4934, scene::Eccentricity{eccentricity_m});
  cell.scene.displacement_m << 0, -0.01;
  cell.scene.velocity_m_per_s.setZero();
  return cell;
}

/// Largest distance from the centre in the last 64 of `turns` turns.
double largest_distance_m(const scene::Scene& scene, long turns,
                          const integrate::run::SolverOptions& solver = {}) {
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(scene, solver, modes);
  integrate::run::TurnRequest request;
  integrate::run::TurnReport turn;
  double largest = 0;
  for (long k = 0; k < turns; ++k) {
    if (k == turns - 64) request.samples_per_revolution = 256;
    EXPECT_EQ(run.advance(request, turn), integrate::run::Outcome::ok);
    for (int i = 0; i < turn.sample_count; ++i) {
      const std::size_t at = turn.section.size() * static_cast<std::size_t>(i);
      largest = std::max(largest, std::hypot(turn.samples[at], turn.samples[at + 1]));
    }
  }
  return largest * scene.length_scale_m;
}

TEST(Settle, ClassAndNumbersAreOfOneMotion) {
  motion::ResponseOptions options = without_floquet_proof();
  options.max_revolutions = 1000;
  int tori = 0;
  for (const double e :
       {0.22, 0.2267, 0.24, 0.26, 0.28, 0.3, 0.3267, 0.3333, 0.3367, 0.34, 0.345, 0.3467, 0.36}) {
    const scene::Cell cell = cell_of_long_transients(e);
    motion::Workspace workspace;
    const SettledRun settled = settle(cell, {}, options, workspace);
    if (settled.motion.motion_class != motion::MotionClass::quasi_periodic) continue;
    ++tori;
    scene::Scene behind = cell.scene;
    integrate::run::set_initial_state(behind, settled.section);
    const double later = largest_distance_m(behind, 3000);
    EXPECT_NEAR(settled.motion.measures.contact.peak_displacement_m, later, 0.05 * later) << e;
  }
  EXPECT_GT(tori, 4);
}

/// A whirl grows from rounding until the solver has to resolve its many vibrations per turn. A run of fewer
/// turns than two windows has shorter ones.
TEST(Settle, ARunThatWorkEndsKeepsTheMeasuresOfItsLastWindows) {
  for (const auto& [growth, least, most] : {std::tuple{0.001, 200, 600}, {0.005, 20, 128}}) {
    test::OneSideRotor rotor;
    scene::Cell cell = test::cell_of(rotor);
    cell.scene.pulses.clear();
    cell.scene.speed_rad_per_s /= 40;
    cell.scene.harmonic_n *= 0.01;
    cell.scene.structure.damping *= -growth;
    integrate::run::SolverOptions solver;
    solver.method = integrate::run::Method::adaptive;
    solver.stepper = integrate::run::Stepper::dopri5;
    solver.max_steps_per_revolution = 2000;
    motion::ResponseOptions options;
    options.floquet_proof = false;
    motion::Workspace workspace;
    const SettledRun settled = settle(cell, solver, options, workspace);
    EXPECT_GT(settled.revolutions, least);
    EXPECT_LT(settled.revolutions, most);
    EXPECT_EQ(settled.motion.motion_class, motion::MotionClass::unsettled);
    EXPECT_EQ(settled.motion.status, motion::MotionStatus::step_limit);
    EXPECT_FALSE(settled.proof);
    EXPECT_FALSE(settled.motion.order);
    const double seen = largest_distance_m(cell.scene, settled.revolutions, solver);
    EXPECT_NEAR(settled.motion.measures.contact.peak_displacement_m, seen, 0.01 * seen);
  }
}

TEST(Settle, ShortestRunKeepsExactlyTwoWindows) {
  motion::ResponseOptions options = without_floquet_proof();
  options.max_revolutions = 128;
  const auto settled = run({}, options);
  EXPECT_EQ(settled.revolutions, 128);
  EXPECT_NE(settled.motion.motion_class, motion::MotionClass::failed);
}

TEST(Settle, NoUnbalanceRestsWithoutAnyLine) {
  test::OneSideRotor rotor;
  rotor.whirl_ratio = 0;
  const auto settled = run(rotor, {});
  EXPECT_EQ(settled.motion.motion_class, motion::MotionClass::non_contact);
  EXPECT_FALSE(settled.motion.measures.dominant);
  EXPECT_EQ(settled.motion.measures.amplitude_1x_forward_m, 0);
}

std::string name(const SettledRun& settled) { return std::string(to_string(settled.motion.motion_class)); }

/// Run with the adaptive solver alone, whose transients lead to the motions named by the tests.
SettledRun run_annular(double speed_hz, double whirl_ratio, double offset_y_m = 0,
                       const motion::ResponseOptions& options = {}) {
  motion::Workspace workspace;
  integrate::run::SolverOptions solver;
  solver.method = integrate::run::Method::adaptive;
  return settle(testing::annular_cell(speed_hz, whirl_ratio, offset_y_m), solver, options, workspace);
}

TEST(Settle, TheAnnulusCirclesAtLowSpeed) {
  const auto settled = run_annular(90, 0.6);
  EXPECT_EQ(name(settled), "synchronous");
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::circle);
  EXPECT_NEAR(settled.motion.measures.contact.contact_fraction, 1, 1e-9);
  EXPECT_FALSE(settled.motion.measures.comb_spacing);
  EXPECT_FALSE(settled.motion.exponent);
}

TEST(Settle, WindowsTooShortForACombAreSearchedForNone) {
  const motion::ResponseOptions options{.max_revolutions = 24,
                                        .samples_per_revolution = 24,
                                        .window_revolutions = 8,
                                        .floquet_proof = false,
                                        .max_order = 4};
  const auto settled = run_annular(165, 0.6, 0, options);
  EXPECT_EQ(settled.outcome, integrate::run::Outcome::ok);
  EXPECT_FALSE(settled.motion.measures.comb_spacing);
}

TEST(Settle, TheAnnulusTurnsOvalsAtHighSpeed) {
  for (const double whirl_ratio : {0.3, 0.6, 0.9}) {
    const auto settled = run_annular(165, whirl_ratio, 0, without_floquet_proof());
    EXPECT_EQ(name(settled), "quasi_periodic");
    EXPECT_EQ(settled.proof, motion::Proof::observed);
    EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::oval);
    EXPECT_FALSE(settled.motion.order || settled.motion.exponent);
    // The largest line is 1X or the next line of the comb; the window's bins are 1/64 wide.
    const double spacing = settled.motion.measures.comb_spacing.value();
    const double off_1x = std::abs(settled.motion.measures.dominant.value().order - 1);
    EXPECT_NEAR(off_1x / spacing, std::round(off_1x / spacing), 1.0 / 64 / spacing);
    EXPECT_GT(spacing, 0.3);
    EXPECT_LT(spacing, 0.8);
  }
}

TEST(Settle, ACombWhoseLinesOverlapIsAnOvalToo) {
  const auto settled = run_annular(120, 0.3231578947368421, 0, without_floquet_proof());
  EXPECT_EQ(name(settled), "quasi_periodic");
  EXPECT_NEAR(settled.motion.measures.comb_spacing.value(), 0.0745, 1e-4);
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::oval);
}

/// The same motion. After 600 turns the section still returns best after three periods. Finally it returns
/// best after one period, as a run of 1200 turns shows.
TEST(Settle, AProofTellsAPeriodFromASlowTransient) {
  const auto settled = run_annular(120, 0.3231578947368421);
  EXPECT_EQ(settled.proof, motion::Proof::floquet_observed);
  EXPECT_NEAR(settled.motion.measures.comb_spacing.value(), 0.223451707, 1e-8);
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::oval);
}

TEST(Settle, AnOvalMayBeChaotic) {
  const auto settled = run_annular(132, 0.2737);
  EXPECT_EQ(name(settled), "chaotic");
  EXPECT_EQ(settled.motion.measures.orbit, spectrum::OrbitKind::oval);
  EXPECT_FALSE(settled.motion.measures.comb_spacing);
  EXPECT_NEAR(settled.motion.exponent.value().per_revolution, 0.19, 0.03);
  EXPECT_EQ(settled.proof, motion::Proof::observed);
}

TEST(Settle, WithAnOffsetTheSameMotionsTakeAnExponent) {
  const auto torus = run_annular(237, 0.778, 2.5e-4);
  EXPECT_EQ(name(torus), "quasi_periodic");
  EXPECT_FALSE(torus.motion.measures.comb_spacing);
  EXPECT_NEAR(torus.motion.exponent.value().per_revolution, 0, 1e-3);
  EXPECT_EQ(torus.revolutions, 600);
  const auto chaos = run_annular(108, 0.98, 2.5e-4);
  EXPECT_EQ(name(chaos), "chaotic");
  EXPECT_NEAR(chaos.motion.exponent.value().per_revolution, 0.33, 0.05);
}

TEST(Settle, AnOrderAboveTheLargestIsUnsettledAndSaysSo) {
  test::OneSideRotor rotor;
  rotor.speed_hz = 102;
  rotor.whirl_ratio = 0.879;
  motion::ResponseOptions options = without_floquet_proof();
  const auto settled = run(rotor, options);
  EXPECT_EQ(name(settled), "unsettled");
  EXPECT_EQ(to_string(settled.motion.status), "order_above_max");
  EXPECT_FALSE(settled.proof);
  // The slowest decay is at least that of the rotor's tangential motion: see section_map_test.
  EXPECT_LT(settled.motion.exponent.value().per_revolution, -0.03);

  // A proof may still find it.
  const auto proven = run(rotor, {});
  EXPECT_EQ(proven.motion.order, 14);
  EXPECT_EQ(proven.proof, motion::Proof::floquet);
  options.max_order = 14;
  EXPECT_EQ(run(rotor, options).motion.order, 14);
}

TEST(Settle, WhileItSettlesItIsNeverCalledAnythingElse) {
  motion::ResponseOptions options = without_floquet_proof();
  options.window_revolutions = 32;
  int measured = 0, not_measured = 0;
  for (options.max_revolutions = 64; options.max_revolutions < 400; options.max_revolutions += 16) {
    const auto settled = run({}, options);
    if (name(settled) == "subharmonic") break;
    EXPECT_EQ(name(settled), "unsettled") << options.max_revolutions;
    EXPECT_EQ(to_string(settled.motion.status), "ok");
    // Where only the newer window has a period, no exponent is computed.
    (settled.motion.exponent ? measured : not_measured) += 1;
  }
  EXPECT_LT(options.max_revolutions, 400);
  EXPECT_GT(measured, 0);
  EXPECT_GT(not_measured, 0);
}

}  // namespace
}  // namespace rubsweep::response
