// Slips that reverse between flat stops: closed forms before and after the reversal, Taylor pieces in
// between. They are compared with long double, with Taylor pieces alone and with differences.
#include <gtest/gtest.h>

#include "core/integrate/expect_long_double.hpp"
#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

/// A thin shaft, whose surface moves at 0.24 m/s. In contact the rotor at times moves backwards at a higher
/// speed, so that the slip reverses.
test::OneSideRotor thin_shaft(double steepness_s_per_m, double radius_m = 5e-4) {
  test::OneSideRotor rotor;
  rotor.contact_radius_m = radius_m;
  rotor.friction_steepness_s_per_m = steepness_s_per_m;
  return rotor;
}

/// The same scene with dry friction.
scene::Scene dry_scene() {
  model::Machine machine = test::machine_of(thin_shaft(100, 3e-4));
  machine.stops[0].friction = model::ConstantFriction{0.1};
  return scene::build_cell(machine, 75, scene::WhirlRatio{0.4}).scene;
}

void expect_reversals(const run::TurnReport& turn) {
  EXPECT_GT(turn.effort.taylor_turns, 0);
  EXPECT_GT(turn.effort.steps, turn.effort.taylor_pieces);  // closed forms cover a part of the motion
  EXPECT_EQ(turn.effort.adaptive_turns, 0);
}

TEST(ReversingSlip, AgainstLongDouble) {
  expect_reversals(expect_long_double(thin_shaft(100), 6, 6000, 1e-12));
}

TEST(ReversingSlip, AgainstLongDoubleWhereHardlyAnythingIsSaturated) {
  expect_long_double(thin_shaft(30), 6, 3000, 1e-12);
}

/// Compares each turn with Taylor pieces alone from the same sections, with all results that a turn can
/// report.
void expect_pieces_alone(const scene::Scene& scene, int turns, double bound, double tangent_bound) {
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, {}, modes);
  taylor::TaylorRun<4> pieces(scene, {});
  run::TurnRequest asked;
  asked.samples_per_revolution = 64;
  asked.peaks = asked.switches = true;
  asked.tangent_vectors.setIdentity(8, 8);
  run::TurnReport a, b;
  long alone = 0;
  for (int k = 0; k < turns; ++k) {
    if (k > 0) pieces.resume(a.section, k);
    ASSERT_EQ(run.advance(asked, a), run::Outcome::ok) << k;
    ASSERT_EQ(pieces.advance(asked, b), run::Outcome::ok) << k;
    EXPECT_LT(largest_difference(a.section, b.section), bound) << k;
    ASSERT_EQ(a.sample_count, 64) << k;
    ASSERT_EQ(b.sample_count, 64) << k;
    a.samples.resize(std::size_t{64} * 8);
    b.samples.resize(std::size_t{64} * 8);
    EXPECT_LT(largest_difference(a.samples, b.samples), bound) << k;
    EXPECT_EQ(a.hits, b.hits) << k;
    EXPECT_EQ(a.switches.size(), b.switches.size()) << k;
    EXPECT_EQ(a.touched, b.touched) << k;
    EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-10) << k;
    EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-5 * b.peak_displacement_m) << k;
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-4 * b.peak_contact_force_n + 1e-9) << k;
    ASSERT_NE(a.tangent_vectors.get(), nullptr) << k;
    const Eigen::MatrixXd& moved = *a.tangent_vectors.get();
    EXPECT_LT((moved - *b.tangent_vectors.get()).cwiseAbs().maxCoeff(),
              tangent_bound * moved.cwiseAbs().maxCoeff())
        << k;
    alone = b.effort.steps;
  }
  EXPECT_GT(a.effort.taylor_pieces, 0);
  EXPECT_LT(2 * a.effort.taylor_pieces, alone);
}

TEST(ReversingSlip, TanhIsAsByPiecesAlone) {
  expect_pieces_alone(test::cell_of(thin_shaft(100)).scene, 12, 1e-11, 1e-9);
}

TEST(ReversingSlip, DryIsAsByPiecesAlone) { expect_pieces_alone(dry_scene(), 12, 1e-11, 1e-9); }

/// Stops on two sides, whose slips have opposite directions under the same rotation.
TEST(ReversingSlip, BetweenTwoStops) {
  model::Machine machine = test::machine_of(thin_shaft(300));
  machine.stops.push_back(machine.stops[0]);
  std::get<model::OneSideGeometry>(machine.stops[1].geometry).angle_deg = -90;
  machine.stops[0].casing = machine.stops[1].casing = {};
  const scene::Scene scene = scene::build_cell(machine, 75, scene::WhirlRatio{0.6}).scene;
  ASSERT_EQ(scene.structure.coordinates(), 2);
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, {}, modes);
  taylor::TaylorRun<2> pieces(scene, {});
  run::TurnReport a, b;
  for (int k = 0; k < 12; ++k) {
    if (k > 0) pieces.resume(a.section, k);
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok) << k;
    ASSERT_EQ(pieces.advance({}, b), run::Outcome::ok) << k;
    EXPECT_LT(largest_difference(a.section, b.section), 1e-11) << k;
  }
  EXPECT_GT(a.effort.taylor_pieces, 0);
  EXPECT_LT(a.effort.taylor_pieces, b.effort.steps);
}

/// A surface that always slips backwards, with saturated friction: no turn needs a Taylor piece.
TEST(ReversingSlip, AlwaysBackwardHasClosedForms) {
  scene::Scene scene = test::cell_of(thin_shaft(100)).scene;
  scene.contacts[0].surface_speed_m_per_s = -16;
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, {}, modes);
  taylor::TaylorRun<4> pieces(scene, {});
  run::TurnReport a, b;
  long switches = 0;
  for (int k = 0; k < 8; ++k) {
    if (k > 0) pieces.resume(a.section, k);
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok) << k;
    ASSERT_EQ(pieces.advance({}, b), run::Outcome::ok) << k;
    EXPECT_LT(largest_difference(a.section, b.section), 1e-12) << k;
    switches = a.effort.switches;
  }
  EXPECT_GT(switches, 4);
  EXPECT_EQ(a.effort.taylor_turns, 0);
}

}  // namespace
}  // namespace rubsweep::integrate
