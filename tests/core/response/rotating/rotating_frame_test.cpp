#include "rubsweep/core/response/rotating/rotating_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/response/annular_cell.hpp"
#include "core/response/rotating/initial_state.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::VectorXd;

TEST(RotatingFrameTurned, TurnsEveryPairFromXToY) {
  const VectorXd state{{1, 0, 0, 2}};
  const VectorXd quarter{{0, 1, -2, 0}};
  EXPECT_LT((turned(state, std::numbers::pi / 2) - quarter).norm(), 1e-15);
  EXPECT_LT((turned(turned(state, 0.7), -0.7) - state).norm(), 1e-15);
}

TEST(RotatingFrameField, StandsStillOnTheClosedFormOfFullAnnularRub) {
  const test::FullRub rub;
  const scene::Scene scene = rub.scene();
  const RotatingField field(scene, {});
  const VectorXd state = initial_state(scene);
  EXPECT_LT(field.rate(state).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_TRUE(field.touches(state));
  EXPECT_FALSE(field.touches(0.8 * state));
  EXPECT_NEAR(field.contact_force_n(state), rub.k_c * (rub.radius - 1), 1e-12);
}

TEST(RotatingFrameField, IsTheSameFromEveryDirection) {
  const auto cell = response::testing::annular_cell(120, 0.6);
  const RotatingField field(cell.scene, {});
  const VectorXd state{{1.2, 0.3, 0.1, -0.05, -0.2, 0.9, 0.1, 0.3}};
  // The unbalance does not turn with the state: only what it adds, the same for all states, tells directions.
  const VectorXd zero = VectorXd::Zero(8);
  const VectorXd here = field.rate(state) - field.rate(zero),
                 there = field.rate(turned(state, 1.1)) - field.rate(zero);
  EXPECT_LT((there - turned(here, 1.1)).cwiseAbs().maxCoeff(), 1e-12);
}

/// Rate of y = turned(x, -phase) along a run of the adaptive solver, by differences.
TEST(RotatingFrameField, IsTheRateOfARunSeenFromTheShaft) {
  auto scene = response::testing::annular_cell(120, 0.6).scene;
  scene.pulses.clear();
  integrate::run::SolverOptions options;
  options.relative_tolerance = 1e-11;
  constexpr int samples = 4096;
  integrate::run::TurnRequest asked;
  integrate::run::TurnReport turn;
  asked.samples_per_revolution = samples;
  scene.displacement_m << 1.15e-3, 0, 2e-5, 0;
  scene.velocity_m_per_s << 0, 0.5, 0.01, 0;
  ASSERT_EQ(integrate::adaptive::start_adaptive(scene, options)(asked, turn), integrate::run::Outcome::ok);
  EXPECT_TRUE(turn.touched);
  const RotatingField field(scene, options);
  const double step = 2 * std::numbers::pi / samples;
  const auto seen = [&](int k) {
    return VectorXd(turned(Eigen::Map<const VectorXd>(turn.samples.data() + 8 * k, 8), -k * step));
  };
  for (int k = 10; k < samples - 10; k += 401) {
    const VectorXd by_differences = (seen(k + 1) - seen(k - 1)) / (2 * step), rate = field.rate(seen(k));
    EXPECT_LT((by_differences - rate).cwiseAbs().maxCoeff(), 1e-3 * rate.cwiseAbs().maxCoeff()) << k;
  }
}

TEST(RotatingFrameField, JacobianIsWhatDifferencesSay) {
  const auto cell = response::testing::annular_cell(120, 0.6);
  for (const auto contact :
       {integrate::run::ContactHandling::located, integrate::run::ContactHandling::smoothed}) {
    integrate::run::SolverOptions options;
    options.contact = contact;
    options.smoothing_m = 1e-4;
    const RotatingField field(cell.scene, options);
    std::mt19937 random(1);
    std::normal_distribution<double> normal(0, 0.05);
    VectorXd state{{1.3, 0.2, 0.1, 0, -0.2, 0.9, 0.1, 0.1}};
    for (int trial = 0; trial < 8; ++trial) {
      for (double& value : state) value += normal(random);
      const Eigen::MatrixXd jacobian = field.jacobian(state);
      for (Eigen::Index j = 0; j < 8; ++j) {
        const VectorXd step = 1e-6 * VectorXd::Unit(8, j);
        const VectorXd column = (field.rate(state + step) - field.rate(state - step)) / 2e-6;
        EXPECT_LT((column - jacobian.col(j)).cwiseAbs().maxCoeff(), 1e-4) << trial << ' ' << j;
      }
    }
  }
}

}  // namespace
}  // namespace rubsweep::response::rotating
