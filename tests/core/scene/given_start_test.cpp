#include "rubsweep/core/scene/given_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/kit_machine.hpp"
#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::scene {
namespace {

model::Machine unkicked() {
  model::Machine machine = one_side_machine();
  machine.kick.reset();
  return machine;
}

const WhirlRatio ratio{0.4};

TEST(GivenStart, SetsWhatIsGivenAndKeepsTheQuietWhirl) {
  model::Machine machine = unkicked();
  const Scene quiet = build_cell(machine, 75, ratio).scene;
  machine.start = {.rotor = {.x_m = 3e-4, .vy_m_per_s = -0.2}};
  const Cell cell = build_cell(machine, 75, ratio);
  EXPECT_EQ(cell.start, Start::quiet);
  EXPECT_TRUE(cell.scene.pulses.empty());
  Eigen::VectorXd displacement_m = quiet.displacement_m, velocity_m_per_s = quiet.velocity_m_per_s;
  displacement_m(0) = 3e-4;
  velocity_m_per_s(1) = -0.2;
  EXPECT_LT((cell.scene.displacement_m - displacement_m).norm(), 1e-18);
  EXPECT_LT((cell.scene.velocity_m_per_s - velocity_m_per_s).norm(), 1e-15);
  EXPECT_EQ(cell.scene.harmonic_n, quiet.harmonic_n);
}

TEST(GivenStart, OfACasingMovesThatCasingAlone) {
  model::Machine machine = both_sides_machine();
  machine.kick.reset();
  const Scene quiet = build_cell(machine, 75, ratio).scene;
  machine.start = {.casings = {std::nullopt, model::BodyState{.y_m = 2e-5, .vx_m_per_s = 0.1}}};
  const Scene scene = build_cell(machine, 75, ratio).scene;
  Eigen::VectorXd displacement_m = quiet.displacement_m, velocity_m_per_s = quiet.velocity_m_per_s;
  displacement_m(5) = 2e-5;  // coordinates: rotor, first casing, second casing
  velocity_m_per_s(4) = 0.1;
  EXPECT_LT((scene.displacement_m - displacement_m).norm(), 1e-18);
  EXPECT_LT((scene.velocity_m_per_s - velocity_m_per_s).norm(), 1e-15);
}

TEST(GivenStart, AnEmptyOneIsTheQuietWhirl) {
  model::Machine machine = unkicked();
  const Scene quiet = build_cell(machine, 75, ratio).scene;
  machine.start.emplace();
  const Scene scene = build_cell(machine, 75, ratio).scene;
  EXPECT_EQ(scene.displacement_m, quiet.displacement_m);
  EXPECT_EQ(scene.velocity_m_per_s, quiet.velocity_m_per_s);
}

/// A displacement of one point bends the shaft like a static force there; a velocity acts like an impulse
/// there.
TEST(GivenStart, OfARotorKitIsAStaticDeflectionAndAnImpulse) {
  model::Machine machine = light_shaft_machine();
  machine.kick.reset();
  model::kit_of(machine)->modes = 3;
  const PreparedMachine prepared = prepare_machine(machine);
  const Scene quiet = build_cell(prepared, 75, ratio).scene;
  PreparedMachine moved = prepared;
  moved.machine.start = {.rotor = {.y_m = 5e-4, .vx_m_per_s = 0.3}};
  const Scene scene = build_cell(moved, 75, ratio).scene;
  const auto& map = scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
  EXPECT_NEAR(map.row(1) * scene.displacement_m, 5e-4, 1e-15);
  EXPECT_NEAR(map.row(0) * scene.velocity_m_per_s, 0.3, 1e-12);
  const auto expect_along = [](const Eigen::VectorXd& force, const Eigen::VectorXd& direction) {
    EXPECT_GT(force.norm(), 0);
    EXPECT_NEAR(std::abs(force.dot(direction)), force.norm() * direction.norm(),
                1e-9 * force.norm() * direction.norm());
  };
  expect_along(prepared.assembly.system.stiffness * (scene.displacement_m - quiet.displacement_m),
               map.row(1).transpose());
  expect_along(prepared.assembly.system.mass * (scene.velocity_m_per_s - quiet.velocity_m_per_s),
               map.row(0).transpose());
}

TEST(GivenStart, AtRestEverythingStandsAndTheMarkIsAlongX) {
  model::Machine machine = both_sides_machine();
  machine.kick.reset();
  machine.gravity_m_per_s2 = 9.81;
  machine.start = {.at_rest = true};
  for (const double speed_hz : {20.0, 75.0}) {
    for (const Unbalance& unbalance : {Unbalance(WhirlRatio{0.4}), Unbalance(WhirlRatio{1.7})}) {
      const Cell cell = build_cell(machine, speed_hz, unbalance);
      EXPECT_TRUE(cell.scene.displacement_m.isZero(0));
      EXPECT_TRUE(cell.scene.velocity_m_per_s.isZero(0));
      EXPECT_EQ(cell.scene.displacement_m.size(), 6);
      EXPECT_EQ(cell.scene.harmonic_n(0).imag(), 0);
      EXPECT_GT(cell.scene.harmonic_n(0).real(), 0);
      EXPECT_LT(cell.scene.constant_n(1), 0);
    }
  }
}

/// Even where the quiet motion would touch, which takes the kick away from other starts.
TEST(GivenStart, AtRestAKickActsFromTheFirstInstant) {
  for (model::Machine machine : {one_side_machine(), light_shaft_machine()}) {
    machine.start = {.at_rest = true};
    for (const double whirl_ratio : {0.4, 1.7}) {
      const Cell cell = build_cell(machine, 75, WhirlRatio{whirl_ratio});
      EXPECT_TRUE(cell.scene.displacement_m.isZero(0));
      ASSERT_EQ(cell.scene.pulses.size(), 1u);
      EXPECT_EQ(cell.scene.pulses[0].elapsed_s, 0);
    }
  }
}

TEST(GivenStart, ExcludesAKickAndARigidCasing) {
  model::Machine machine = one_side_machine();
  machine.start.emplace();
  EXPECT_THROW(build_cell(machine, 75, ratio), ConfigError);
  machine.kick.reset();
  EXPECT_NO_THROW(build_cell(machine, 75, ratio));
  machine.start->casings = {model::BodyState{.x_m = 1e-5}};
  EXPECT_NO_THROW(build_cell(machine, 75, ratio));
  machine.stops[0].casing.reset();
  EXPECT_THROW(build_cell(machine, 75, ratio), ConfigError);
}

}  // namespace
}  // namespace rubsweep::scene
