// Flights by closed forms and contacts by a stepper, against the stepper alone.
#include "rubsweep/core/integrate/flight_run.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstddef>
#include <numbers>
#include <variant>
#include <vector>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using namespace test_curved;

run::SolverOptions tight(run::Method method) {
  run::SolverOptions options;
  options.relative_tolerance = 1e-12;
  options.method = method;
  return options;
}

/// Expects the same turns of both runs, with all that a turn may report.
void expect_equal_turns(const scene::Scene& scene, int turns, double tolerance, int& hits, int& moved) {
  exact::modes::ModeCache modes;
  ASSERT_TRUE(may_fly(scene, tight(run::Method::automatic)));
  const run::Run flights = start(scene, tight(run::Method::automatic), modes),
                 steps = start(scene, tight(run::Method::adaptive), modes);
  run::TurnRequest asked;
  asked.peaks = asked.switches = true;
  asked.samples_per_revolution = 7;
  asked.tangent_vectors.setIdentity(8, 1);
  asked.tangent_accuracy = 1e-10;
  run::TurnRequest also_asked = asked;
  run::TurnReport a, b;
  for (int k = 0; k < turns; ++k) {
    ASSERT_EQ(flights.advance(asked, a), run::Outcome::ok);
    ASSERT_EQ(steps.advance(also_asked, b), run::Outcome::ok);
    EXPECT_LT(distance(a.section, b.section), tolerance);
    EXPECT_EQ(a.sample_count, b.sample_count);
    EXPECT_LT(distance(a.samples, b.samples), tolerance);
    EXPECT_EQ(a.hits, b.hits);
    EXPECT_EQ(a.touching_at_end, b.touching_at_end);
    EXPECT_NEAR(a.contact_fraction, b.contact_fraction, tolerance);
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-6 * b.peak_contact_force_n);
    ASSERT_EQ(a.switches.size(), b.switches.size());
    for (std::size_t i = 0; i < a.switches.size(); ++i) {
      EXPECT_EQ(a.switches[i].to, b.switches[i].to);
      EXPECT_NEAR(a.switches[i].phase_rad, b.switches[i].phase_rad, tolerance);
    }
    // A contact with a damping of its own that touches at the start moves no vector that begins there.
    ASSERT_EQ(a.tangent_vectors.get() == nullptr, b.tangent_vectors.get() == nullptr);
    if (!a.tangent_vectors.get()) continue;
    asked.tangent_vectors = *a.tangent_vectors.get();
    also_asked.tangent_vectors = *b.tangent_vectors.get();
    EXPECT_LT((asked.tangent_vectors - also_asked.tangent_vectors).norm(),
              1e-6 * also_asked.tangent_vectors.norm());
    ++moved;
    hits += a.hits;
  }
}

TEST(FlightRun, RandomMachinesMoveAsTheStepperAloneMovesThem) {
  int hits = 0, moved = 0;
  // In the last, a contact touches while another is deep.
  for (const unsigned seed : {1U, 4U, 7U, 10U, 12U, 16U, 160U})
    expect_equal_turns(RandomMachine(seed).scene, 3, 1e-9, hits, moved);
  EXPECT_GT(hits, 20);
  EXPECT_GT(moved, 12);
}

TEST(FlightRun, ARunMayBeginInsideTheWall) {
  scene::Scene scene = RandomMachine(13).scene;
  const double clearance_m = scene.contacts[0].clearance_m;
  const auto* wall = std::get_if<contact::FlatWall>(&scene.contacts[0].wall);
  ASSERT_NE(wall, nullptr);
  scene.displacement_m.head(2) = 1.01 * clearance_m * wall->normal;
  int hits = 0, moved = 0;
  expect_equal_turns(scene, 2, 1e-9, hits, moved);
}

/// A kick ends during a flight or a contact, or in the next turn.
TEST(FlightRun, AKickMayEndAtAnyInstant) {
  int hits = 0, moved = 0;
  for (const double duration_s : {0.003, 0.005, 0.008, 0.011, 0.013, 0.017, 0.025}) {
    scene::Scene scene = RandomMachine(4).scene;
    scene.pulses.push_back(
        {.direction = Eigen::Vector4d(0.6, 0.8, 0, 0), .force_n = 50, .duration_s = duration_s});
    expect_equal_turns(scene, 2, 1e-9, hits, moved);
  }
  EXPECT_GT(hits, 20);
}

/// A turn depends on its section and vectors alone, also after a restart in mid-air: to the last bit and
/// step.
TEST(FlightRun, StartsAgainWithoutMemory) {
  exact::modes::ModeCache modes;
  const run::Run run = start(RandomMachine(4).scene, tight(run::Method::automatic), modes);
  run::TurnRequest asked;
  asked.tangent_vectors.setIdentity(8, 2);
  const std::vector<double> section(8, 0.01);
  run.restart(section);
  run::TurnReport start, first, turn, again;
  ASSERT_EQ(run.advance(asked, start), run::Outcome::ok);
  run.restart(section);
  ASSERT_EQ(run.advance(asked, first), run::Outcome::ok);
  for (int k = 0; k < 3; ++k) ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
  const run::Effort before = turn.effort;
  run.restart(section);
  ASSERT_EQ(run.advance(asked, again), run::Outcome::ok);
  EXPECT_GT(first.hits, 0);
  EXPECT_EQ(first.section, again.section);
  EXPECT_EQ(*first.tangent_vectors.get(), *again.tangent_vectors.get());
  EXPECT_EQ(first.effort.steps - start.effort.steps, again.effort.steps - before.steps);
}

/// The limit of a turn holds for all its contacts together, each of which stays far below it.
TEST(FlightRun, ATurnHasOneLimit) {
  for (const unsigned seed : {17U, 21U, 23U}) {
    const scene::Scene scene = RandomMachine(seed).scene;
    exact::modes::ModeCache modes;
    run::SolverOptions options = tight(run::Method::automatic);
    run::TurnReport turn;
    ASSERT_EQ(start(scene, options, modes).advance({}, turn), run::Outcome::ok);
    const std::vector<double> section = turn.section;
    const auto made = [&](long most) {
      options.max_steps_per_revolution = most;
      const run::Run run = start(scene, options, modes);
      run.restart(section);
      return run.advance({}, turn);
    };
    ASSERT_EQ(made(1'000'000), run::Outcome::ok);
    ASSERT_GE(turn.hits, 4);
    const long needed = turn.effort.steps + turn.effort.refused;
    EXPECT_EQ(made(needed + 1), run::Outcome::ok) << seed;
    EXPECT_EQ(made(needed / 2), run::Outcome::step_limit) << seed;
  }
}

/// In flights no right-hand side is evaluated.
TEST(FlightRun, FlightsTakeNoSteps) {
  scene::Scene scene = test::one_mass_scene(2, 0, 0, 2 * std::numbers::pi, 1e-3);
  scene.contacts.push_back(test::wall_across_x(1, 1e-3, 1, 0));
  give_law(power_stop(1e4, 1.5), scene.contacts[0]);
  scene.structure.stiffness.diagonal().setConstant(100);
  scene.velocity_m_per_s << 1e-4, 0;
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, tight(run::Method::automatic), modes);
  run::TurnReport turn;
  for (int k = 0; k < 3; ++k) ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
  EXPECT_EQ(turn.hits, 0);
  EXPECT_LT(turn.effort.rhs_calls, 10);
}

TEST(FlightRun, OnlyBesideALawThatIsNotLinear) {
  scene::Scene scene = RandomMachine(1).scene;
  EXPECT_TRUE(may_fly(scene, {}));
  EXPECT_FALSE(may_fly(scene, {.method = run::Method::adaptive}));
  EXPECT_FALSE(may_fly(scene, {.stepper = run::Stepper::dopri5}));
  for (scene::Contact& contact : scene.contacts) contact.law = nullptr;
  EXPECT_FALSE(may_fly(scene, {}));
}

}  // namespace
}  // namespace rubsweep::integrate
