#include "rubsweep/core/integrate/exact/modes/mode_change.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <memory>

#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

using contact::Mode;
using State = Eigen::Matrix<double, 8, 1>;

/// A rotor of parameter set A without a kick, with a stop of this stiffness.
scene::Scene against(double stiffness_n_per_m) {
  test::OneSideRotor rotor;
  rotor.stiffness_n_per_m = stiffness_n_per_m;
  scene::Scene scene = test::cell_of(rotor).scene;
  scene.pulses.clear();
  return scene;
}

/// A state in which the rotor penetrates the casing by a thousandth of the clearance.
State pressed() {
  State state;
  state << 0.3, 1.051, 0.02, 0.05, 40, 70, 3, 60;
  return state;
}

std::size_t joint_of(Mode mode) { return in_joint_mode(mode, 0); }

/// The state stays the same when changing between any two modes, including open and modes without a modal
/// form.
TEST(ModeChange, LeavesTheStateWhereItIs) {
  const scene::Scene scene = against(2e6);
  auto machine = std::make_shared<MachineModes<4>>(scene);
  for (const Mode from : {Mode::open, Mode::clamped, Mode::sprung, Mode::released}) {
    for (const Mode to : {Mode::open, Mode::clamped, Mode::sprung, Mode::released}) {
      ExactMotion<4> motion(scene, machine);
      motion.set_phases(0.7);
      ASSERT_TRUE(motion.enter(joint_of(from), pressed()));
      ASSERT_TRUE(motion.change(joint_of(to)));
      EXPECT_EQ(motion.joint(), joint_of(to));
      const State off = motion.physical() - pressed();
      EXPECT_LT(off.head(4).cwiseAbs().maxCoeff(), 5e-15);
      EXPECT_LT(off.tail(4).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

/// Tangent vectors are transformed by the same matrix as through displacements.
TEST(ModeChange, TakesTangentVectorsAlong) {
  const scene::Scene scene = against(2e6);
  auto machine = std::make_shared<MachineModes<4>>(scene);
  ExactMotion<4> motion(scene, machine);
  motion.set_phases(0.7);
  ASSERT_TRUE(motion.enter(joint_of(Mode::sprung), pressed()));
  const Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity(8, 8);
  motion.carry_tangents(vectors);
  ASSERT_TRUE(motion.change(joint_of(Mode::clamped)));
  Eigen::MatrixXd now(8, 8);
  motion.put_tangents(now);
  EXPECT_LT((now - vectors).cwiseAbs().maxCoeff(), 1e-13);
}

/// Changes between two modes of a contact a thousand times stiffer than usual, and back. Going through
/// displacements would lose a thousand times the rounding of the fast pair; this change loses no more than
/// its rounding.
TEST(ModeChange, KeepsTheDigitsOfAStiffContact) {
  const scene::Scene scene = against(2e9);
  auto machine = std::make_shared<MachineModes<4>>(scene);
  ExactMotion<4> there(scene, machine), through(scene, machine);
  const std::size_t sprung = joint_of(Mode::sprung), clamped = joint_of(Mode::clamped);
  for (ExactMotion<4>* motion : {&there, &through}) {
    motion->set_phases(0.7);
    ASSERT_TRUE(motion->enter(sprung, pressed()));
  }
  const State start = there.free();
  // The guard depends mainly on the fastest pair.
  const auto& guard = there.mode().guards.front();
  const auto penetration = [&](const ExactMotion<4>& motion) {
    return (guard.physical * (motion.mode().basis * (motion.free() - start)).eval()).value();
  };
  double kept = 0, lost = 0;
  for (int k = 0; k < 20; ++k) {
    ASSERT_TRUE(there.change(clamped) && there.change(sprung));
    kept = std::max(kept, std::abs(penetration(there)));
    ASSERT_TRUE(through.enter(clamped, through.physical()) && through.enter(sprung, through.physical()));
    lost = std::max(lost, std::abs(penetration(through)));
  }
  EXPECT_LT(kept, 2e-17);
  EXPECT_GT(lost, 4 * kept);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
