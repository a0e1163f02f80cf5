#include "rubsweep/core/integrate/exact/slip_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

using contact::Mode;
using State = Eigen::Matrix<double, 8, 1>;

/// A rotor of parameter set A in contact by a hundredth of the clearance, with this surface speed.
struct Touching {
  scene::Scene scene = test::cell_of({}).scene;
  std::shared_ptr<modes::MachineModes<4>> machine = std::make_shared<modes::MachineModes<4>>(scene);
  ExactMotion<4> motion{scene, machine};
  SlipWatch<4> watch;
  State start;

  explicit Touching(double surface_speed_m_per_s) : Touching(with_surface(surface_speed_m_per_s)) {}
  explicit Touching(const scene::Scene& of) : scene(of), watch(scene, machine->friction()) {
    start << 0.2, 1.01, 0, 0, 100, -50, 1, -2;  // velocities per second
    motion.set_phases(0);
    EXPECT_TRUE(motion.enter(0, start));
  }
  static scene::Scene with_surface(double speed_m_per_s) {
    scene::Scene scene = test::cell_of({}).scene;
    scene.contacts[0].surface_speed_m_per_s = speed_m_per_s;
    return scene;
  }
  bool enter(Mode mode) {
    const auto joint = watch.saturated_mode(*machine, modes::in_joint_mode(mode, 0), start);
    return joint && motion.enter(*joint, start);
  }
  double slip_m_per_s(const State& at) const {
    return scene.contacts[0].surface_speed_m_per_s +
           scene.length_scale_m * machine->system().contacts[0].second_row.dot(at.tail(4).transpose());
  }
};

/// Friction stays saturated over the longest stretch. Where the slip approaches the end of saturation, the
/// stretch is hardly shorter than necessary.
TEST(SlipWatch, AStretchKeepsFrictionSaturated) {
  for (const Mode mode : {Mode::clamped, Mode::sprung, Mode::released}) {
    for (const double surface_m_per_s : {0.3, 0.5, 1.0, 5.0, -0.3, -1.0, -5.0}) {
      Touching touching(surface_m_per_s);
      if (!touching.enter(mode)) continue;
      ASSERT_TRUE(touching.watch.begin(touching.motion, touching.start, 0)) << surface_m_per_s;
      const double stretch_s = touching.watch.longest_s();
      EXPECT_GT(stretch_s, 0);
      EXPECT_LE(stretch_s, touching.motion.mode().longest_step_s);
      const double way = touching.motion.mode().touches[0].way,
                   above = touching.machine->friction()[0].above_m_per_s;
      constexpr int parts = 50;
      for (int i = 0; i < parts; ++i) {
        touching.motion.step_by(stretch_s / parts);
        EXPECT_GT(way * touching.slip_m_per_s(touching.motion.physical()), above * (1 - 1e-12))
            << surface_m_per_s << ' ' << i;
      }
    }
  }
}

TEST(SlipWatch, TheGuardIsWhatIsLeftOfTheSlipAndItsRate) {
  for (const double surface_m_per_s : {1.0, -1.0}) {
    Touching touching(surface_m_per_s);
    ASSERT_TRUE(touching.enter(Mode::sprung));
    const auto guard = touching.watch.guard(touching.motion, 0, touching.start);
    const double above = touching.machine->friction()[0].above_m_per_s;
    EXPECT_NEAR(guard.value, above - std::abs(touching.slip_m_per_s(touching.start)), 1e-12);
    const double h = 1e-7 * touching.motion.mode().longest_step_s;
    const double before = touching.slip_m_per_s(touching.motion.physical());
    touching.motion.step_by(h);
    const double rate = (touching.slip_m_per_s(touching.motion.physical()) - before) / h;
    const double way = touching.motion.mode().touches[0].way;
    EXPECT_NEAR(guard.rate, -way * rate, 1e-4 * std::abs(rate) + 1e-3);
  }
}

/// A sticking contact has a slip of rounding size. Static friction would drop at this slip and release the
/// contact, so it is not saturated. Dry friction would hold the contact again at once, so it is saturated.
TEST(SlipWatch, ASlipOfRoundingIsNoneWhereFrictionJumps) {
  const auto saturated_at = [](const model::Friction& friction, double slip_m_per_s) {
    scene::Scene scene = Touching::with_surface(0);
    scene.contacts[0].friction = friction;
    const double still = Touching(scene).slip_m_per_s(Touching(scene).start);
    scene.contacts[0].surface_speed_m_per_s = slip_m_per_s - still;
    Touching touching(scene);
    EXPECT_NEAR(touching.slip_m_per_s(touching.start), slip_m_per_s, 1e-14);
    return touching.watch
        .saturated_mode(*touching.machine, modes::in_joint_mode(Mode::sprung, 0), touching.start)
        .has_value();
  };
  for (const double way : {1, -1}) {
    EXPECT_FALSE(saturated_at(model::StaticFriction{0.4, 0.2}, way * 3e-14));
    EXPECT_TRUE(saturated_at(model::StaticFriction{0.4, 0.2}, way * 1e-9));
    EXPECT_TRUE(saturated_at(model::StaticFriction{0.2, 0.2}, way * 3e-14));
    EXPECT_TRUE(saturated_at(model::ConstantFriction{0.2}, way * 3e-14));
  }
}

/// A surface that moves backward drives the rotor in the opposite direction.
TEST(SlipWatch, TheModeHasTheWayOfTheSlip) {
  Touching forward(5), backward(-5), slow(-0.1);
  ASSERT_TRUE(forward.enter(Mode::sprung));
  ASSERT_TRUE(backward.enter(Mode::sprung));
  EXPECT_EQ(forward.motion.joint(), modes::in_joint_mode(Mode::sprung, 0));
  EXPECT_EQ(backward.motion.joint(),
            modes::in_joint_mode(Mode::sprung, 0) + modes::backward_in_joint_mode(0, 1));
  EXPECT_EQ(modes::modes_of_joint_mode(backward.motion.joint(), 1), forward.motion.joint());
  // Friction has the same magnitude and opposite signs in both cases.
  const auto &there = forward.motion.mode().stiffness, &back = backward.motion.mode().stiffness;
  const auto& open = forward.machine->mode(0)->stiffness;
  const auto& c = forward.machine->system().contacts[0];
  const Eigen::VectorXd along = (there - back) * c.first_row.transpose() / (2 * c.first_row.squaredNorm());
  EXPECT_NEAR((along + 0.1 * c.stiffness * c.second_push).norm(), 0, 1e-9 * along.norm());
  EXPECT_GT((there - open).norm(), 0);
  // At rest in contact, with a slip of 0.1 m/s; the tanh law saturates at 0.14 m/s.
  slow.start << 0, 1.01, 0, 0, 0, 0, 0, 0;
  EXPECT_FALSE(slow.enter(Mode::sprung));
}

}  // namespace
}  // namespace rubsweep::integrate::exact
