#include "rubsweep/core/response/rotating/limit_cycle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "rubsweep/core/numerics/full_turn.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::response::rotating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// r' = a r (1 - r^2), angle' = w, s' = -b s: the limit cycle r = 1, s = 0 has the period T = 2 pi / w and
/// the multipliers 1, e^{-2 a T} and e^{-b T}.
struct NormalForm {
  double a = 0.1, w = 0.6, b = 0.3;
  double push_out = 0;  ///< jump at r < 0.95, which derivatives do not show

  double period() const { return numerics::full_turn / w; }
  VectorXd rate(const VectorXd& y) const {
    const double growth = a * (1 - y.head(2).squaredNorm());
    return VectorXd{{growth * y(0) - w * y(1), growth * y(1) + w * y(0), -b * y(2)}};
  }
  VectorXd after(const VectorXd& y, double t) const {
    const double r = std::hypot(y(0), y(1)), decay = std::exp(-2 * a * t);
    const double grown = 1 / std::sqrt(r * r + (1 - r * r) * decay) + (r < 0.95 ? push_out / r : 0);
    const double c = std::cos(w * t), s = std::sin(w * t);
    return VectorXd{{grown * (c * y(0) - s * y(1)), grown * (s * y(0) + c * y(1)), std::exp(-b * t) * y(2)}};
  }
  RotatingArc arc(const VectorXd& y, double t) const {
    RotatingArc arc;
    arc.end = after(y, t);
    arc.angle_rad = t;
    arc.transition.resize(3, 3);
    for (Eigen::Index j = 0; j < 3; ++j) {
      const VectorXd step = 1e-5 * VectorXd::Unit(3, j);
      arc.transition.col(j) = (after(y + step, t) - after(y - step, t)) / 2e-5;
    }
    return arc;
  }
  RotatingMotion motion() const {
    const auto flow = [*this](const VectorXd& y, double t) { return std::optional(arc(y, t)); };
    return {[*this](const VectorXd& y) { return rate(y); }, flow, flow, flow,
            [*this](const VectorXd& y, double t) { return std::optional(after(y, t)); }};
  }
};

const VectorXd near_the_cycle{{0.6 * 0.97, 0.8 * 0.97, 0.01}};

TEST(LimitCycleProve, FindsPeriodStateAndModulus) {
  const NormalForm form;
  const auto cycle = prove_limit_cycle(form.motion(), near_the_cycle, {1.005 * form.period()});
  ASSERT_TRUE(cycle);
  EXPECT_NEAR(cycle->once.angle_rad, form.period(), 1e-8);
  EXPECT_NEAR(cycle->state.head(2).norm(), 1, 1e-9);
  EXPECT_NEAR(cycle->state(2), 0, 1e-9);
  const double slower = std::max(std::exp(-2 * form.a * form.period()), std::exp(-form.b * form.period()));
  EXPECT_NEAR(cycle->floquet_modulus, slower, 1e-8);
}

TEST(LimitCycleProve, TakesTheFirstPeriodThatCloses) {
  const NormalForm form;
  const double once = form.period();
  const auto cycle =
      prove_limit_cycle(form.motion(), near_the_cycle, {0.6 * once, 1.005 * once, 2.01 * once});
  ASSERT_TRUE(cycle);
  EXPECT_NEAR(cycle->once.angle_rad, once, 1e-8);
}

TEST(LimitCycleProve, IsOfTheSmallestPeriod) {
  const NormalForm form;
  for (const int k : {1, 2, 3, 5, 6, 12, 49}) {
    const auto cycle = prove_limit_cycle(form.motion(), near_the_cycle, {1.0002 * k * form.period()});
    ASSERT_TRUE(cycle) << k;
    EXPECT_NEAR(cycle->once.angle_rad, form.period(), 1e-8) << k;
  }
}

TEST(LimitCycleProve, TakesNoDerivativeAgainNearBy) {
  const NormalForm form;
  RotatingMotion motion = form.motion();
  int at_first = 0, roughly = 0, exactly = 0;
  const auto count = [](RotatingMotion::Flow& flow, int& calls) {
    flow = [&calls, counted = flow](const VectorXd& y, double t) {
      ++calls;
      return counted(y, t);
    };
  };
  count(motion.at_first, at_first);
  count(motion.roughly, roughly);
  count(motion.exactly, exactly);
  ASSERT_TRUE(prove_limit_cycle(motion, VectorXd{{0.9995, 0, 1e-4}}, {form.period()}));
  EXPECT_EQ(at_first, 1);
  EXPECT_EQ(roughly, 0);
  EXPECT_EQ(exactly, 1);
  ASSERT_TRUE(prove_limit_cycle(motion, near_the_cycle, {1.005 * form.period()}));
  EXPECT_EQ(at_first, 2);
  EXPECT_GE(roughly, 1);
}

/// A stepper's motion is only as smooth as its tolerance.
TEST(LimitCycleProve, TheRoughFlowMayBeNoisy) {
  const NormalForm form;
  RotatingMotion motion = form.motion();
  double noise = 2e-6;
  motion.end = [&](const VectorXd& y, double t) {
    noise = -noise;
    return std::optional<VectorXd>(form.after(y, t) + VectorXd{{noise, -noise, noise}});
  };
  const auto cycle = prove_limit_cycle(motion, near_the_cycle, {1.005 * form.period()});
  ASSERT_TRUE(cycle);
  EXPECT_NEAR(cycle->state.head(2).norm(), 1, 1e-9);
}

TEST(LimitCycleProve, RefusesAnUnstableOne) {
  for (const auto& [a, b] : {std::pair{-0.01, 0.3}, std::pair{0.1, -0.01}, std::pair{0.1, 1e-9}}) {
    NormalForm form;
    form.a = a;
    form.b = b;
    EXPECT_FALSE(prove_limit_cycle(form.motion(), near_the_cycle, {form.period()})) << a << ' ' << b;
  }
}

TEST(LimitCycleProve, RefusesATransientThatGoesElsewhere) {
  NormalForm form;
  form.push_out = 1;
  const VectorXd start{{0.94, 0, 0}};
  EXPECT_FALSE(prove_limit_cycle(form.motion(), start, {form.period()}));
  form.push_out = 0;
  EXPECT_TRUE(prove_limit_cycle(form.motion(), start, {form.period()}));
}

/// Flows only go forward: a backward call would read a state that does not exist.
TEST(LimitCycleProve, RefusesATransientThatIsThrownAheadByMoreThanAPeriod) {
  const NormalForm form;
  const VectorXd start{{0.54, 0.72, 0}}, along{{-0.8, 0.6, 0}};
  RotatingMotion motion = form.motion();
  int thrown = 0;
  motion.end = [&](const VectorXd& y, double t) -> std::optional<VectorXd> {
    EXPECT_GT(t, 0);
    if (y.norm() > 0.95) return form.after(y, t);
    ++thrown;
    return form.after(y, t) + 2 * form.period() * form.w * along;
  };
  EXPECT_FALSE(prove_limit_cycle(motion, start, {form.period()}));
  EXPECT_EQ(thrown, 1);
}

TEST(LimitCycleProve, GivesUpATransientThatComesNoNearer) {
  NormalForm form;
  form.a = 1e-4;
  RotatingMotion standing = form.motion();
  int periods = 0;
  standing.end = [&](const VectorXd& y, double) {
    ++periods;
    return std::optional(y);
  };
  EXPECT_FALSE(prove_limit_cycle(standing, near_the_cycle, {form.period()}));
  EXPECT_GT(periods, 10);
  EXPECT_LT(periods, 100);
}

TEST(LimitCycleProve, RefusesWhatIsFarAwayAFixedPointAndAFailure) {
  const NormalForm form;
  EXPECT_FALSE(prove_limit_cycle(form.motion(), VectorXd{{0.5, 0, 0}}, {form.period()}));
  EXPECT_FALSE(prove_limit_cycle(form.motion(), VectorXd{{1e-9, 0, 0}}, {form.period()}));
  EXPECT_FALSE(prove_limit_cycle(form.motion(), near_the_cycle, {1.4 * form.period()}));
  RotatingMotion broken = form.motion();
  broken.roughly = [](const VectorXd&, double) { return std::optional<RotatingArc>(); };
  EXPECT_FALSE(prove_limit_cycle(broken, near_the_cycle, {form.period()}));
}

/// Flows of three accuracies from one state: each is as accurate as it claims, whatever was computed before.
TEST(LimitCycle, AreAsGoodAsTheySay) {
  auto scene = test::annular_scene(1, 0.02, 1.4, 0.05, 0, 40, 0.3);
  scene.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  scene.displacement_m(0) = 1.2 * scene.length_scale_m;
  const integrate::run::SolverOptions solver;
  const RotatingField field(scene, solver);
  const CycleFlows flows(scene, solver, 16);
  const RotatingMotion motion = flows.motion(field);
  const Eigen::VectorXd start{{1.2, 0.1, 0.2, -0.6}};
  const double angle_rad = 9;
  const auto best = RotatingFlow(scene, solver, 0).with(1e-12, 0).from(start, angle_rad);
  ASSERT_TRUE(best);
  EXPECT_GT(best->contact_fraction, 0.1);
  const auto off = [&](const std::optional<RotatingArc>& arc) {
    return arc ? (arc->end - best->end).cwiseAbs().maxCoeff() : 1;
  };
  const auto derivative_off = [&](const std::optional<RotatingArc>& arc) {
    return (arc->transition - best->transition).cwiseAbs().maxCoeff() /
           best->transition.cwiseAbs().maxCoeff();
  };
  for (int round = 0; round < 2; ++round) {
    const auto exact = motion.exactly(start, angle_rad), rough = motion.roughly(start, angle_rad),
               first = motion.at_first(start, angle_rad);
    EXPECT_LT(off(exact), 1e-12);
    EXPECT_LT(off(rough), 1e-6);
    EXPECT_LT(off(first), 1e-4);
    EXPECT_GT(off(first), off(exact));
    EXPECT_LT(derivative_off(exact), 1e-9);
    EXPECT_LT(derivative_off(rough), 1e-5);
    EXPECT_LT(derivative_off(first), 1e-3);
    EXPECT_EQ(exact->samples.cols(), 23);
    EXPECT_EQ(rough->samples.cols(), 0);
    const auto end = motion.end(start, angle_rad);
    ASSERT_TRUE(end);
    EXPECT_LT((*end - best->end).cwiseAbs().maxCoeff(), 1e-6);
  }
}

}  // namespace
}  // namespace rubsweep::response::rotating
