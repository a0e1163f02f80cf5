#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "integrate/rubbing_kit.hpp"
#include "rubsweep/bench/long_double_run.hpp"
#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/scene/quiet_motion.hpp"
#include "support/annular_scene.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using Complex = std::complex<double>;

template <class A, class B>
double largest_difference(const A& a, const B& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, static_cast<double>(std::abs(a[i] - b[i])));
  return largest;
}

/// A scene with a force of twice the shaft's frequency that is `share` of the one that turns, in other
/// directions.
scene::Scene with_second(scene::Scene scene, Complex share) {
  scene.second_harmonic_n = share * scene.harmonic_n.conjugate();
  return scene;
}

/// Turns by the solver that `options` choose, by dopri5 and in long double, from the same start.
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
  scene::Scene scene = test::annular_scene(1, 0.05, 0.6, 0.9, Complex(0.1, -0.2), 30, 0.1);
  const run::Effort effort = expect_agreement(with_second(scene, std::polar(0.5, 0.9)), {}, 8, 1e-11);
  EXPECT_GT(effort.taylor_turns, 0);
}

/// A kick that begins and ends beside it leaves it as it is.
TEST(TwicePerTurn, APulseOfTheSceneComesAndGoesBesideIt) {
  scene::Scene scene = with_second(test::cell_of({}).scene, std::polar(0.6, 0.4));
  scene::Pulse late = scene.pulses.at(0);
  late.elapsed_s = -1.3 * scene.period_s();
  scene.pulses.push_back(late);
  expect_agreement(scene, {}, 5, 1e-11);
}

/// The quiet motion of both orders stays where it is: as a closed form, and by series.
TEST(TwicePerTurn, TheQuietMotionRepeats) {
  for (const bool annular : {false, true}) {
    scene::Scene scene = test::one_mass_scene(2, 800, 3, 0.31, 1e-3);
    scene.harmonic_n << 0.3, Complex(0, -0.2);
    scene.second_harmonic_n = Eigen::Vector2cd(Complex(0.4, 0.1), Complex(0.2, -0.5));
    scene.constant_n << 0.1, -0.2;
    scene.contacts = {test::wall_across_x(1, 1, 1e5, 0)};
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
        const Eigen::Vector2d expected = quiet.displacement(2 * std::numbers::pi * s / 16) / 1e-3;
        const Eigen::Map<const Eigen::Vector2d> found(turn.samples.data() + 4 * s);
        EXPECT_LT((found - expected).norm(), 1e-12 * (1 + expected.norm())) << annular << ' ' << s;
      }
    }
  }
}

/// Friction that holds leaves the closed form of a stretch without slip to Taylor series.
TEST(TwicePerTurn, AStickingContactIsLeftToSeries) {
  scene::Scene scene = test::one_mass_scene(1, 1, 0.1, 2 * std::numbers::pi / 0.7, 1);
  scene.harmonic_n << 0.2, Complex(0, -0.2);
  scene.second_harmonic_n = Eigen::Vector2cd(Complex(0, 0.3), 0.2);
  scene.constant_n << 2, 0;
  scene.displacement_m << 1.05, 0;
  scene::Contact wall = test::wall_across_x(1, 1, 20, 0.5);
  wall.friction = model::ConstantFriction{0.6};
  scene.contacts = {wall};
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

/// Tangent vectors are those of finite differences in long double.
TEST(TwicePerTurn, TangentVectorsAreThoseOfTheMotion) {
  const scene::Scene scene = with_second(test::cell_of({}).scene, std::polar(0.6, 0.4));
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnReport turn;
  run::TurnRequest asked;
  asked.tangent_vectors = Eigen::MatrixXd::Identity(8, 8);
  bench::LongDoubleRun reference(scene, 1e-16L);
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    reference.advance_turn();
  }
  const bench::LongDoubleRun::State here = reference.section();
  const Eigen::MatrixXd expected = bench::monodromy(reference, here, 3).cast<double>();
  ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
  EXPECT_GT(turn.hits, 0);
  ASSERT_NE(turn.tangent_vectors.get(), nullptr);
  EXPECT_LT((*turn.tangent_vectors.get() - expected).norm(), 1e-8 * expected.norm());
}

}  // namespace
}  // namespace rubsweep::integrate
