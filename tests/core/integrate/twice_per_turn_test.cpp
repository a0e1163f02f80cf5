#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "bench/long_double_run.hpp"
#include "core/integrate/largest_difference.hpp"
#include "core/integrate/rubbing_kit.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate {
namespace {

using Complex = std::complex<double>;

/// The scene plus a force at twice the shaft's frequency, which is `share` times the rotating force, in other
/// directions.
scene::Scene with_second(scene::Scene scene, Complex share) {
  scene.second_harmonic_n = share * scene.harmonic_n.conjugate();
  return scene;
}

/// Compares turns by the solver in `options`, by dopri5 and in long double from the same start.
run::Effort expect_agreement(const scene::Scene& scene, const run::SolverOptions& options, int turns,
                             double tolerance) {
  exact::modes::ModeCache modes;
  const run::Run found = start(scene, options, modes);
  const run::Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-12});
  bench::LongDoubleRun reference(scene, 1e-16L);
  run::TurnReport a, b;
  int hits = 0;
  for (int k = 0; k < turns; ++k) {
    EXPECT_EQ(found.advance({}, a), run::Outcome::ok);
    EXPECT_EQ(adaptive({}, b), run::Outcome::ok);
    reference.advance_turn();
    hits += a.hits;
    EXPECT_EQ(a.hits, b.hits) << k;
    EXPECT_LT(largest_difference(a.section, reference.section()), tolerance) << k;
    EXPECT_LT(largest_difference(b.section, reference.section()), 1e-8) << k;
  }
  EXPECT_GE(hits, 2);
  return a.effort;
}

TEST(TwicePerTurn, ClosedFormsThatRubAgreeWithTwoOtherSolvers) {
  const run::Effort effort =
      expect_agreement(with_second(test::cell_of({}).scene, std::polar(0.6, 0.4)), {}, 8, 1e-11);
  EXPECT_EQ(effort.taylor_turns + effort.adaptive_turns, 0);
  EXPECT_EQ(effort.rhs_calls, 0);
}

TEST(TwicePerTurn, AKitsClosedFormsAgreeToo) {
  const run::Effort effort =
      expect_agreement(with_second(kit_scene(70, 0.7), std::polar(0.3, -1.0)), {}, 6, 1e-10);
  EXPECT_EQ(effort.taylor_turns + effort.adaptive_turns, 0);
}

TEST(TwicePerTurn, TaylorSeriesInAnAnnularStopAgree) {
  scene::Scene scene = with_second(test::cell_of({}).scene, std::polar(0.5, 0.9));
  scene.contacts[0].wall = contact::AnnularWall{};
  scene.constant_n(1) += 3;
  const run::Effort effort = expect_agreement(scene, {}, 8, 1e-10);
  EXPECT_GT(effort.taylor_turns, 0);
}

/// A kick that begins and ends does not change the second harmonic.
TEST(TwicePerTurn, APulseOfTheSceneComesAndGoesBesideIt) {
  scene::Scene scene = with_second(test::cell_of({}).scene, std::polar(0.6, 0.4));
  scene::Pulse late = scene.pulses.at(0);
  late.elapsed_s = -1.3 * scene.period_s();
  scene.pulses.push_back(late);
  expect_agreement(scene, {}, 5, 1e-11);
}

/// The quiet motion of both orders repeats exactly: in closed form, and by series.
TEST(TwicePerTurn, TheQuietMotionRepeats) {
  for (const bool annular : {false, true}) {
    scene::Scene scene = with_second(test::cell_of({.kick_n = 0}).scene, std::polar(0.5, 0.9));
    scene.pulses.clear();
    scene.constant_n(1) = -0.2;
    scene.contacts[0].clearance_m = 1;
    if (annular) scene.contacts[0].wall = contact::AnnularWall{};
    const scene::QuietMotion quiet = scene::quiet_motion(
        scene.structure, scene.speed_rad_per_s, scene.harmonic_n, scene.constant_n, scene.second_harmonic_n);
    scene.displacement_m = quiet.displacement(0);
    scene.velocity_m_per_s = scene.speed_rad_per_s * quiet.velocity(0);
    exact::modes::ModeCache modes;
    const run::Run run = start(scene, {}, modes);
    run::TurnReport turn;
    const run::TurnRequest asked{.samples_per_revolution = 16};
    for (int k = 0; k < 3; ++k) {
      ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
      for (int s = 0; s < 16; ++s) {
        const Eigen::Vector4d expected =
            quiet.displacement(2 * std::numbers::pi * s / 16) / scene.length_scale_m;
        const Eigen::Map<const Eigen::Vector4d> found(turn.samples.data() + 8 * s);
        EXPECT_LT((found - expected).norm(), 1e-12 * (1 + expected.norm())) << annular << ' ' << s;
      }
    }
  }
}

/// With sticking friction, the closed form for stretches without slip gives way to Taylor series.
TEST(TwicePerTurn, AStickingContactIsLeftToSeries) {
  scene::Scene scene = test::cell_of({.kick_n = 0, .whirl_ratio = 0}).scene;
  scene.contacts[0].friction = model::ConstantFriction{0.1};
  scene.contacts[0].surface_speed_m_per_s = 0;
  scene.constant_n(1) += 40;
  scene.harmonic_n(0) = 3;
  scene.second_harmonic_n = Eigen::Vector4cd(Complex(0, 2), 1, 0, 0);
  scene.displacement_m(1) = 0.9e-3;
  scene.velocity_m_per_s.setZero();
  exact::modes::ModeCache modes;
  const run::Run found = start(scene, {}, modes);
  const run::Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-12});
  run::TurnReport a, b;
  for (int k = 0; k < 6; ++k) {
    ASSERT_EQ(found.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(adaptive({}, b), run::Outcome::ok);
    EXPECT_LT(largest_difference(a.section, b.section), 1e-8) << k;
  }
  EXPECT_GT(a.effort.taylor_turns, 0);
}

/// Tangent vectors agree with finite differences in long double.
TEST(TwicePerTurn, TangentVectorsAreThoseOfTheMotion) {
  const scene::Scene scene = with_second(test::cell_of({}).scene, std::polar(0.6, 0.4));
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnReport turn;
  run::TurnRequest asked;
  asked.tangent_vectors = Eigen::MatrixXd::Identity(8, 8);
  bench::LongDoubleRun reference(scene, 1e-16L);
  for (int k = 0; k < 8; ++k) {
    const bench::LongDoubleRun::State before = reference.section();
    ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
    if (k > 0 && turn.hits > 0) {
      const Eigen::MatrixXd expected = bench::monodromy(reference, before, k).cast<double>();
      ASSERT_NE(turn.tangent_vectors.get(), nullptr);
      EXPECT_LT((*turn.tangent_vectors.get() - expected).norm(), 1e-8 * expected.norm());
      return;
    }
    reference.advance_turn();
  }
  FAIL() << "no turn has a hit";
}

}  // namespace
}  // namespace rubsweep::integrate
