#include "rubsweep/core/integrate/taylor/tangent_expansion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "core/integrate/taylor/set_c_scene.hpp"
#include "rubsweep/core/integrate/adaptive/adaptive_run.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "rubsweep/core/response/rotating/rotating_flow.hpp"
#include "support/annular_scene.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::taylor {
namespace {

Eigen::MatrixXd transition_by_dopri5(const scene::Scene& scene, double tolerance = 1e-13) {
  const auto states = std::size_t(2 * scene.structure.coordinates());
  adaptive::AdaptiveRun<response::rotating::VariationalDynamics<Eigen::Dynamic, false>> run(
      scene, {.stepper = run::Stepper::dopri5, .relative_tolerance = tolerance});
  run::TurnReport turn;
  EXPECT_EQ(run.advance({}, turn), run::Outcome::ok);
  return Eigen::Map<const Eigen::MatrixXd>(turn.section.data() + states, Eigen::Index(states),
                                           Eigen::Index(states));
}

TEST(TangentExpansion, MovesAsTheVariationalEquations) {
  exact::modes::ModeCache modes;
  scene::Scene flat = test::cell_of({}).scene;
  flat.displacement_m(1) = 1.1e-3;
  scene::Scene circle = set_c_scene(80, 0.6), slipping = set_c_scene(90, 0.6, {1e-4, 1e-4});
  circle.displacement_m.head(2) << 1.5e-3, 0;
  circle.velocity_m_per_s.head(2) << 0, 0.7;
  slipping.contacts[0].surface_speed_m_per_s = 0.1;
  slipping.contacts[0].friction = model::StribeckFriction{{0.05, 30, 3, 0.1, 30, 0.001}};
  slipping.displacement_m.head(2) << 1.3e-3, 0.2e-3;
  slipping.velocity_m_per_s.head(2) << 0.1, -0.5;
  scene::Scene thin = flat;
  thin.contacts[0].surface_speed_m_per_s = 0.1;
  thin.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 30, 0}};
  for (scene::Scene& scene : std::array{flat, circle, slipping, thin}) {
    scene.pulses.clear();
    const Eigen::MatrixXd expected = transition_by_dopri5(scene);
    TaylorRun<4> run(scene, {});
    run::TurnReport turn;
    ASSERT_EQ(run.advance({.tangent_vectors = Eigen::MatrixXd::Identity(8, 8)}, turn), run::Outcome::ok);
    EXPECT_GT(turn.contact_fraction, 0.04);
    ASSERT_TRUE(turn.tangent_vectors.get());
    const Eigen::MatrixXd all = *turn.tangent_vectors.get();
    EXPECT_LT((all - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
    // A single direction uses the recurrences themselves; several use a shared Jacobian.
    TaylorRun<4> again(scene, {});
    ASSERT_EQ(again.advance({.tangent_vectors = Eigen::VectorXd::Unit(8, 5)}, turn), run::Outcome::ok);
    ASSERT_TRUE(turn.tangent_vectors.get());
    EXPECT_LT((*turn.tangent_vectors.get() - all.col(5)).cwiseAbs().maxCoeff(),
              1e-12 * all.cwiseAbs().maxCoeff());
  }
  const auto exact = start_hybrid(flat, {}, modes);
  TaylorRun<4> run(flat, {});
  run::TurnReport a, b;
  const run::TurnRequest asked{.tangent_vectors = Eigen::MatrixXd::Identity(8, 8)};
  ASSERT_EQ(run.advance(asked, a), run::Outcome::ok);
  ASSERT_EQ(exact.advance(asked, b), run::Outcome::ok);
  ASSERT_TRUE(a.tangent_vectors.get() && b.tangent_vectors.get());
  EXPECT_LT((*a.tangent_vectors.get() - *b.tangent_vectors.get()).cwiseAbs().maxCoeff(), 1e-11);
}

/// The circle of a full annular rub is a slow motion with a long series. A disturbance of it excites the fast
/// vibration of the contact, which must limit the step as well.
TEST(TangentExpansion, FollowsWhatTheMotionDoesNotExcite) {
  for (const double stiffness : {10.0, 1e3, 1e4}) {
    test::FullRub rub;
    rub.k_c = stiffness;
    const scene::Scene scene = rub.scene();
    const Eigen::MatrixXd expected = transition_by_dopri5(scene, 1e-11);
    TaylorRun<2> run(scene, {});
    run::TurnReport turn;
    ASSERT_EQ(run.advance({.tangent_vectors = Eigen::MatrixXd::Identity(4, 4)}, turn), run::Outcome::ok);
    ASSERT_TRUE(turn.tangent_vectors.get());
    EXPECT_LT((*turn.tangent_vectors.get() - expected).cwiseAbs().maxCoeff(),
              1e-8 * expected.cwiseAbs().maxCoeff())
        << stiffness;
  }
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
