#include "rubsweep/core/response/rotating/rotating_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <vector>

#include "core/response/annular_cell.hpp"
#include "core/response/rotating/initial_state.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

integrate::run::SolverOptions tight() {
  integrate::run::SolverOptions options;
  options.relative_tolerance = 1e-11;
  return options;
}

/// A rotor that bounces around the annular stop: every mode occurs within a turn.
scene::Scene bouncing() {
  auto scene = response::testing::annular_cell(120, 0.6).scene;
  scene.pulses.clear();
  scene.displacement_m << 0.9e-3, 0, 2e-5, 0;
  scene.velocity_m_per_s << 0.3, 0.5, 0.01, 0;
  return scene;
}

TEST(RotatingFlow, OneTurnIsThatOfTheAdaptiveSolver) {
  const auto scene = bouncing();
  integrate::run::TurnRequest asked;
  integrate::run::TurnReport turn;
  asked.peaks = true;
  asked.samples_per_revolution = 16;
  ASSERT_EQ(integrate::adaptive::start_adaptive(scene, tight())(asked, turn), integrate::run::Outcome::ok);
  const auto arc = RotatingFlow(scene, tight(), 16).from(initial_state(scene), numerics::full_turn);
  ASSERT_TRUE(arc);
  EXPECT_GT(turn.hits, 0);
  EXPECT_EQ(arc->hits, turn.hits);
  EXPECT_NEAR(arc->contact_fraction, turn.contact_fraction, 1e-8);
  EXPECT_NEAR(arc->peak_displacement_m, turn.peak_displacement_m, 1e-11);
  EXPECT_NEAR(arc->peak_contact_force_n, turn.peak_contact_force_n, 1e-3);
  EXPECT_NEAR(arc->peak_casing_displacement_m, turn.peak_casing_displacement_m, 1e-10);
  const VectorXd section = Eigen::Map<const VectorXd>(turn.section.data(), 8);
  EXPECT_LT((arc->end - section).cwiseAbs().maxCoeff(), 1e-8);
  const MatrixXd samples = Eigen::Map<const MatrixXd>(turn.samples.data(), 8, 16);
  ASSERT_EQ(arc->samples.cols(), 16);
  EXPECT_LT((arc->samples - samples).cwiseAbs().maxCoeff(), 1e-7);
}

/// Longer steps of a loose tolerance, through impacts and in two rings: errors stay below 2 % of the
/// tolerance.
TEST(RotatingFlow, ARoughOneIsAsGoodAsItsTolerance) {
  auto two_rings = test::FullRub{}.scene();
  two_rings.displacement_m *= 1.1;
  integrate::run::SolverOptions rough;
  rough.relative_tolerance = 1e-6;
  for (const scene::Scene& scene : {bouncing(), two_rings}) {
    for (const double angle : {1.0, 4.4, numerics::full_turn}) {
      const auto best = RotatingFlow(scene, tight(), 0).end_from(initial_state(scene), angle);
      const auto end = RotatingFlow(scene, rough, 0).end_from(initial_state(scene), angle);
      ASSERT_TRUE(best && end);
      const double error = (*end - *best).cwiseAbs().maxCoeff();
      EXPECT_LT(error, 2e-8) << angle;
      EXPECT_GT(error, 0) << angle;
    }
  }
}

/// For fixed size, dynamic size and the smoothed law: the derivative agrees with differences of the solver.
TEST(RotatingFlow, TransitionIsWhatDifferencesSay) {
  const auto two_rings = [] {
    auto scene = test::FullRub{}.scene();
    scene.displacement_m *= 1.1;
    return scene;
  };
  integrate::run::SolverOptions smoothed = tight();
  smoothed.contact = integrate::run::ContactHandling::smoothed;
  smoothed.smoothing_m = 1e-5;
  for (const auto& [scene, options] :
       {std::pair{bouncing(), tight()}, std::pair{two_rings(), tight()}, std::pair{bouncing(), smoothed}}) {
    const RotatingFlow flow(scene, options, 0);
    const VectorXd start = initial_state(scene);
    const double angle = 4.4;
    const auto arc = flow.from(start, angle);
    ASSERT_TRUE(arc);
    for (Eigen::Index j = 0; j < start.size(); ++j) {
      const VectorXd step = 1e-5 * VectorXd::Unit(start.size(), j);
      const VectorXd column =
          (flow.from(start + step, angle)->end - flow.from(start - step, angle)->end) / 2e-5;
      EXPECT_LT((column - arc->transition.col(j)).cwiseAbs().maxCoeff(),
                2e-4 * (1 + column.cwiseAbs().maxCoeff()))
          << j;
    }
  }
}

TEST(RotatingFlow, TwoStretchesAreOne) {
  const auto scene = bouncing();
  const RotatingFlow flow(scene, tight(), 32);
  const double a = 1.7, b = 9.1;
  const auto first = flow.from(initial_state(scene), a), whole = flow.from(initial_state(scene), a + b);
  ASSERT_TRUE(first && whole);
  const auto second = flow.from(first->end, b);
  ASSERT_TRUE(second);
  EXPECT_LT((second->end - whole->end).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((second->transition * first->transition - whole->transition).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_EQ(first->hits + second->hits, whole->hits);
  EXPECT_NEAR((a * first->contact_fraction + b * second->contact_fraction) / (a + b), whole->contact_fraction,
              1e-8);
  EXPECT_EQ(whole->samples.cols(), static_cast<Eigen::Index>(32 * (a + b) / numerics::full_turn) + 1);
}

TEST(RotatingFlow, StandsStillOnFullAnnularRub) {
  const auto scene = test::FullRub{}.scene();
  const auto arc = RotatingFlow(scene, tight(), 0).from(initial_state(scene), 20.0);
  ASSERT_TRUE(arc);
  EXPECT_LT((arc->end - initial_state(scene)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(arc->hits, 0);
  EXPECT_NEAR(arc->contact_fraction, 1, 1e-12);
}

TEST(RotatingFlow, SaysWhenTheSolverFails) {
  integrate::run::SolverOptions options = tight();
  options.max_steps_per_revolution = 10;
  const auto scene = bouncing();
  EXPECT_FALSE(RotatingFlow(scene, options, 0).from(initial_state(scene), numerics::full_turn));
}

}  // namespace
}  // namespace rubsweep::response::rotating
