#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::scene {
namespace {

using std::numbers::pi;

/// Bending stiffness at the centre of the light shaft and its springs: Euler-Bernoulli plus Cowper's shear.
double middle_stiffness(const model::RotorKit& kit) {
  const auto& s = kit.shaft.front();
  const double area = pi / 4 * s.outer_diameter_m * s.outer_diameter_m;
  const double moment = area * s.outer_diameter_m * s.outer_diameter_m / 16;
  const double nu = s.youngs_modulus_pa / (2 * s.shear_modulus_pa) - 1;
  const double shear = 6 * (1 + nu) / (7 + 6 * nu) * s.shear_modulus_pa * area;
  const double l = s.length_m;
  const double bent = l * l * l / (48 * s.youngs_modulus_pa * moment) + l / (4 * shear);
  return 1 / (bent + 1 / (2 * kit.supports.front().stiffness_x_n_per_m));
}

void expect_near(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected, double relative) {
  ASSERT_EQ(found.rows(), expected.rows());
  ASSERT_EQ(found.cols(), expected.cols());
  EXPECT_LT((found - expected).norm(), relative * expected.norm());
}

TEST(KitScene, LightShaftIsTheJeffcottRotor) {
  const model::Machine kit = light_shaft_machine();
  model::Machine jeffcott = one_side_machine();
  std::get<model::JeffcottRotor>(jeffcott.rotor).natural_frequency_hz =
      std::sqrt(middle_stiffness(*model::kit_of(kit)) / 0.8) / (2 * pi);
  for (const double speed_hz : {20.0, 75.0, 190.0}) {
    const Cell found = build_cell(kit, speed_hz, WhirlRatio{0.4});
    const Cell expected = build_cell(jeffcott, speed_hz, WhirlRatio{0.4});
    EXPECT_NEAR(found.eccentricity_m, expected.eccentricity_m, 1e-9 * expected.eccentricity_m);
    expect_near(found.scene.structure.mass, expected.scene.structure.mass, 1e-9);
    expect_near(found.scene.structure.stiffness, expected.scene.structure.stiffness, 1e-9);
    expect_near(found.scene.structure.damping, expected.scene.structure.damping, 1e-9);
    expect_near(found.scene.displacement_m, expected.scene.displacement_m, 1e-9);
    expect_near(found.scene.velocity_m_per_s, expected.scene.velocity_m_per_s, 1e-9);
    expect_near(found.scene.harmonic_n.real(), expected.scene.harmonic_n.real(), 1e-9);
    expect_near(found.scene.pulses.at(0).direction, expected.scene.pulses.at(0).direction, 1e-9);
    EXPECT_NEAR(found.scene.contacts[0].damping_ns_per_m, expected.scene.contacts[0].damping_ns_per_m, 1e-8);
    for (std::size_t i = 0; i < 2; ++i) {
      expect_near(found.scene.structure.points[i == 0 ? 0 : found.scene.structure.points.size() - 1].map,
                  expected.scene.structure.points[i].map, 1e-9);
    }
  }
}

TEST(KitScene, GravitySagsAsTheJeffcottRotor) {
  model::Machine kit = light_shaft_machine();
  kit.gravity_m_per_s2 = 9.81;
  const Cell cell = build_cell(kit, 60, WhirlRatio{0.2});
  const Eigen::Vector2d mean = cell.scene.structure.points[0].map * cell.quiet.mean;
  EXPECT_NEAR(mean.y(), -0.8 * 9.81 / middle_stiffness(*model::kit_of(kit)), 1e-10);
  EXPECT_EQ(mean.x(), 0);
}

TEST(KitScene, GyroscopicTermGrowsWithTheSpeed) {
  model::Machine machine = light_shaft_machine();
  model::kit_of(machine)->discs[0].position_m = 0.1;
  model::kit_of(machine)->modes = 2;
  const PreparedMachine prepared = prepare_machine(machine);
  const auto skew = [&](double speed_hz) {
    const Eigen::MatrixXd c = build_cell(prepared, speed_hz, WhirlRatio{0.4}).scene.structure.damping;
    return Eigen::MatrixXd(c - c.transpose());
  };
  EXPECT_GT(skew(50).norm(), 0);
  expect_near(skew(100), 2 * skew(50), 1e-14);
}

TEST(KitScene, BowIsFixedAndTheUnbalanceMakesUpTheWhirlRatio) {
  model::Machine machine = light_shaft_machine();
  model::Bow bow;
  bow.shape = model::BowMode{.mode = 1, .amplitude_m = 1e-4};
  bow.phase_deg = 150;
  model::kit_of(machine)->bow = bow;
  for (const double speed_hz : {12.0, 70.0}) {
    const Cell cell = build_cell(machine, speed_hz, WhirlRatio{0.5});
    ASSERT_EQ(cell.start, Start::quiet);
    const auto [mean, amplitude] =
        quiet_penetration(cell.quiet, cell.scene.structure, cell.scene.contacts[0]);
    EXPECT_NEAR(amplitude, 0.5e-3, 1e-12);
    EXPECT_NEAR(mean, -1e-3, 1e-15);
    // The gap is smallest at t = 0.
    const double up = (cell.scene.structure.points[0].map * cell.scene.displacement_m).y();
    EXPECT_NEAR(up, 0.5e-3, 1e-12);
    // Defined by its eccentricity, it is the same cell.
    const Cell back = build_cell(machine, speed_hz, Eccentricity{cell.eccentricity_m});
    EXPECT_NEAR(back.whirl_ratio, 0.5, 1e-12);
    expect_near(back.scene.displacement_m, cell.scene.displacement_m, 1e-12);
  }
}

TEST(KitScene, SlowlyTurningBowedShaftFollowsItsBowOnItsSupports) {
  model::Machine machine = light_shaft_machine();
  for (auto& support : model::kit_of(machine)->supports)
    support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = 1e9;
  model::kit_of(machine)->bow = model::Bow{
      .shape = model::BowPoints{.position_m = {0, 0.2, 0.4}, .deflection_m = {0, 2e-4, 0}}, .phase_deg = 0};
  const Cell cell = build_cell(machine, 0.01, Eccentricity{0});
  const Eigen::Vector2cd amplitude = cell.scene.structure.points[0].map * cell.quiet.amplitude;
  EXPECT_NEAR(std::abs(amplitude.x()), 2e-4, 1e-9);
  EXPECT_NEAR(std::abs(amplitude.y()), 2e-4, 1e-9);
  EXPECT_NEAR(cell.whirl_ratio, 0.2, 1e-6);
}

TEST(KitScene, ABowAcrossTheUnbalanceCannotBeMadeSmaller) {
  model::Machine machine = light_shaft_machine();
  model::kit_of(machine)->bow =
      model::Bow{.shape = model::BowMode{.mode = 1, .amplitude_m = 4e-4}, .phase_deg = 90};
  EXPECT_EQ(build_cell(machine, 10, WhirlRatio{0.1}).start, Start::unreachable);
  // A bow opposite to the unbalance can be compensated: two eccentricities do so, and the larger one is used.
  model::kit_of(machine)->bow->phase_deg = 180;
  const Cell cell = build_cell(machine, 10, WhirlRatio{0.1});
  EXPECT_EQ(cell.start, Start::quiet);
  EXPECT_GT(build_cell(machine, 10, Eccentricity{1.001 * cell.eccentricity_m}).whirl_ratio, 0.1);
}

TEST(KitScene, TorsionIsACoordinateThatTurnsTheUnbalance) {
  model::Machine machine = light_shaft_machine();
  model::kit_of(machine)->torsion =
      model::Torsion{.drive_stiffness_nm_per_rad = 50, .drive_damping_nms_per_rad = 0.01};
  const Cell cell = build_cell(machine, 60, WhirlRatio{0.3});
  const auto& scene = cell.scene;
  ASSERT_EQ(scene.structure.coordinates(), 5);  // x, y, twist angle, casing x and y
  EXPECT_NEAR(scene.structure.mass(2, 2), 4e-4, 1e-12);
  EXPECT_EQ(scene.structure.stiffness(2, 2), 50);
  ASSERT_TRUE(scene.twist);
  EXPECT_EQ(scene.twist->coordinate, 2);
  EXPECT_EQ(scene.twist->contact_radius_m, std::vector<double>{0.0375});
  // The unbalance of the twisting shaft is that of the quiet whirl.
  const double w = scene.speed_rad_per_s;
  EXPECT_NEAR((w * w * scene.twist->unbalance_kg_m - scene.harmonic_n).norm(), 0,
              1e-12 * scene.harmonic_n.norm());
  EXPECT_EQ(scene.harmonic_n(2), 0.0);
  machine.stops[0].geometry = model::AnnularGeometry{};
  EXPECT_TRUE(build_cell(machine, 60, WhirlRatio{0.3}).scene.twist);
}

TEST(KitScene, KickActsWhereItIsSaid) {
  model::Machine machine = light_shaft_machine();
  model::kit_of(machine)->modes = 2;
  const Cell middle = build_cell(machine, 60, WhirlRatio{0.3});
  machine.kick->position_m = 0.1;
  const Cell beside = build_cell(machine, 60, WhirlRatio{0.3});
  EXPECT_LT(beside.scene.pulses.at(0).direction.cwiseAbs().maxCoeff(),
            middle.scene.pulses.at(0).direction.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace rubsweep::scene
