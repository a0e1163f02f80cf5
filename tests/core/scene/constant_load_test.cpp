#include "rubsweep/core/scene/constant_load.hpp"

#include <gtest/gtest.h>

#include "core/scene/kit_machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::scene {
namespace {

constexpr double gravity = 9.81;

/// The machine without its casing, which would sag, too.
model::Machine light() {
  model::Machine machine = light_shaft_machine();
  machine.stops[0].casing.reset();
  return machine;
}

model::Machine heavy() {
  model::Machine machine = light();
  machine.gravity_m_per_s2 = gravity;
  return machine;
}

/// Sag of a disc at the centre of a light shaft of 10 mm diameter and 0.4 m length on two springs.
double sag_of_the_disc_m() {
  const model::RotorKit kit = *model::kit_of(light_shaft_machine());
  const double moment = 3.14159265358979323846 / 64 * 1e-8, area = 3.14159265358979323846 / 4 * 1e-4;
  const double nu = 2.1 / 1.62 - 1, shear = 6 * (1 + nu) / (7 + 6 * nu) * 8.1e10 * area;
  const double bending = 0.4 * 0.4 * 0.4 / (48 * 2.1e11 * moment) + 0.4 / (4 * shear);
  return 0.8 * gravity * (bending + 1 / (2 * 3e4));
}

TEST(ConstantLoadSag, IsThatOfTheWeightOnShaftAndSprings) {
  const Eigen::Vector2d sag = sag_m(prepare_machine(heavy()), 0);
  EXPECT_EQ(sag.x(), 0);
  EXPECT_NEAR(sag.y(), -sag_of_the_disc_m(), 1e-9 * sag_of_the_disc_m());
  EXPECT_TRUE(sag_m(prepare_machine(light_shaft_machine()), 0).isZero(0));
}

TEST(ConstantLoadStatic, OfTheWeightMovesTheShaftAsTheWeightDoes) {
  model::Machine machine = light();
  model::kit_of(machine)->static_loads = {{.position_m = 0.2, .force_y_n = -0.8 * gravity}};
  const Eigen::Vector2d sag = sag_m(prepare_machine(machine), 0);
  EXPECT_NEAR(sag.y(), -sag_of_the_disc_m(), 1e-9 * sag_of_the_disc_m());
  model::kit_of(machine)->static_loads = {{.position_m = 0.2, .force_x_n = 3},
                                          {.position_m = 0.2, .force_x_n = 4}};
  EXPECT_NEAR(sag_m(prepare_machine(machine), 0).x(), 7 / (0.8 * gravity) * sag_of_the_disc_m(), 1e-12);
}

/// A clearance measured from the sagged shaft equals one from the straight axis, increased by the sag.
TEST(ConstantLoad, ClearancesFromTheSagAreOthersFromTheAxis) {
  model::Machine from_sag = heavy(), from_axis = heavy();
  model::kit_of(from_sag)->clearances_from_sag = true;
  ASSERT_DOUBLE_EQ(std::get<model::OneSideGeometry>(from_axis.stops[0].geometry).angle_deg, 90);
  const Eigen::Vector2d sag = sag_m(prepare_machine(from_axis), 0);
  from_axis.stops[0].clearance_m = from_sag.stops[0].clearance_m + sag.y();
  const auto excursion = [](const model::Machine& machine) {
    const Cell cell = build_cell(prepare_machine(machine), 40, Eccentricity{1e-5});
    return quiet_penetration(cell.quiet, cell.scene.structure, cell.scene.contacts[0]);
  };
  const auto a = excursion(from_sag), b = excursion(from_axis);
  EXPECT_NEAR(a.mean, b.mean, 1e-15);
  EXPECT_NEAR(a.amplitude, b.amplitude, 1e-15);
  EXPECT_TRUE(constant_load_n(prepare_machine(from_sag)).isZero(0));
}

}  // namespace
}  // namespace rubsweep::scene
