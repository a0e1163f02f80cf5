#include "rubsweep/analysis/design/static_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/scene/kit_machine.hpp"

namespace rubsweep::design {
namespace {

using std::numbers::pi;

constexpr double length_m = 1.2, diameter_m = 0.05, density = 7850, youngs_pa = 2.1e11, shear_pa = 8.1e10;
constexpr double bearing_n_per_m = 2e7;

model::Support bearing_at(double position_m) {
  model::Support support;
  support.position_m = position_m;
  support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = bearing_n_per_m;
  return support;
}

/// Uniform shaft on bearings at both ends.
model::RotorKit uniform_shaft() {
  model::RotorKit kit;
  kit.shaft = {{{.outer_diameter_m = diameter_m,
                 .youngs_modulus_pa = youngs_pa,
                 .shear_modulus_pa = shear_pa,
                 .density_kg_per_m3 = density,
                 .shear_coefficient = model::ShearCoefficient::none},
                length_m}};
  kit.supports = {bearing_at(0), bearing_at(length_m)};
  kit.elements = 10;
  return kit;
}

const double weight_n_per_m = density * pi / 4 * diameter_m * diameter_m * standard_gravity_m_per_s2;
const double bending_nm2 = youngs_pa * pi / 64 * std::pow(diameter_m, 4);

/// Sections at a place, before and behind its node.
std::vector<Section> at(const StaticLine& line, double position_m) {
  std::vector<Section> found;
  for (const Section& section : line.sections.value())
    if (std::abs(section.position_m - position_m) < 1e-9) found.push_back(section);
  return found;
}

double deflection_y(const StaticLine& line, double position_m) {
  const auto place =
      std::ranges::min_element(line.position_m, {}, [&](double one) { return std::abs(one - position_m); });
  return line.deflection_m[1](place - line.position_m.begin());
}

TEST(StaticLine, OfAUniformShaftIsThatOfTheTextbook) {
  const StaticLine line = static_line(uniform_shaft(), {});
  const double whole_n = weight_n_per_m * length_m;
  ASSERT_EQ(line.loads.size(), 2u);
  for (const BearingLoad& load : line.loads) {
    EXPECT_NEAR(load.load_n[1], -whole_n / 2, 1e-9 * whole_n);
    EXPECT_EQ(load.load_n[0], 0);
  }
  for (const double share : {0.1, 0.3, 0.5, 0.8}) {
    const double z = share * length_m;
    const std::vector<Section> both = at(line, z);
    ASSERT_EQ(both.size(), 2u);
    for (const Section& section : both) {
      EXPECT_NEAR(section.moment_nm[1], weight_n_per_m * z * (length_m - z) / 2, 1e-8 * whole_n);
      EXPECT_NEAR(section.shear_n[1], weight_n_per_m * (length_m / 2 - z), 1e-9 * whole_n);
      EXPECT_EQ(section.moment_nm[0], 0);
    }
  }
  EXPECT_NEAR(at(line, 0)[1].shear_n[1], whole_n / 2, 1e-9 * whole_n);
  EXPECT_NEAR(at(line, length_m)[1].shear_n[1], 0, 1e-9 * whole_n);
  EXPECT_NEAR(at(line, length_m)[1].moment_nm[1], 0, 1e-9 * whole_n);
  const double sag_m =
      5 * weight_n_per_m * std::pow(length_m, 4) / (384 * bending_nm2) + whole_n / 2 / bearing_n_per_m;
  EXPECT_NEAR(deflection_y(line, length_m / 2), -sag_m, 1e-7 * sag_m);
}

TEST(StaticLine, LoadsInXAndDiscsBendTheirOwnPlane) {
  model::RotorKit kit = uniform_shaft();
  kit.static_loads = {{.position_m = 0.3, .force_x_n = 500}};
  kit.discs = {{.position_m = 0.9, .mass_kg = 40, .polar_inertia_kg_m2 = 1, .diametral_inertia_kg_m2 = 0.5}};
  const StaticLine line = static_line(kit, {}), without_weight = static_line(kit, {}, 0);
  EXPECT_NEAR(line.loads[0].load_n[0], 500 * 0.75, 1e-7);
  EXPECT_NEAR(line.loads[1].load_n[0], 500 * 0.25, 1e-7);
  // 500 N a b / L along +x: a moment of that sign bends the shaft towards -x.
  EXPECT_NEAR(at(line, 0.3)[0].moment_nm[0], -500 * 0.3 * 0.9 / length_m, 1e-6);
  EXPECT_NEAR(at(line, 0.3)[1].shear_n[0] - at(line, 0.3)[0].shear_n[0], 500, 1e-7);
  const double disc_n = 40 * standard_gravity_m_per_s2;
  EXPECT_NEAR(at(line, 0.9)[0].moment_nm[1], disc_n * 0.9 * 0.3 / length_m + weight_n_per_m * 0.9 * 0.3 / 2,
              1e-6);
  EXPECT_NEAR(line.loads[1].load_n[1], -(disc_n * 0.75 + weight_n_per_m * length_m / 2), 1e-6);
  EXPECT_EQ(without_weight.loads[1].load_n[1], 0);
  EXPECT_NEAR(without_weight.loads[1].load_n[0], 125, 1e-7);
}

TEST(StaticLine, HeldAgainstTiltingTheEndsBendBack) {
  model::RotorKit kit = uniform_shaft();
  const double tilt_nm = 3e5;
  for (model::Support& support : kit.supports) support.angular_stiffness_nm_per_rad = tilt_nm;
  const StaticLine line = static_line(kit, {});
  const double clamped = weight_n_per_m * length_m * length_m / 12,
               end = clamped / (1 + 2 * bending_nm2 / (tilt_nm * length_m));
  EXPECT_NEAR(at(line, 0)[1].moment_nm[1], -end, 1e-6 * end);
  EXPECT_NEAR(at(line, length_m / 2)[0].moment_nm[1], 1.5 * clamped - end, 1e-6 * end);
}

/// Cone of a shaft that overhangs its bearings: loads and moment from its volume.
TEST(StaticLine, OfAConeIsThatOfItsVolume) {
  model::RotorKit kit = uniform_shaft();
  kit.shaft.front().outer_diameter_end_m = 0.02;
  kit.supports = {bearing_at(0.1), bearing_at(0.8)};
  const StaticLine line = static_line(kit, {});
  double whole_n = 0, about_first_nm = 0, beyond_nm = 0;
  constexpr int slices = 200000;
  for (int k = 0; k < slices; ++k) {
    const double z = (k + 0.5) * length_m / slices, d = diameter_m + (0.02 - diameter_m) * z / length_m;
    const double slice_n = density * pi / 4 * d * d * standard_gravity_m_per_s2 * length_m / slices;
    whole_n += slice_n;
    about_first_nm += slice_n * (z - 0.1);
    if (z > 0.8) beyond_nm += slice_n * (z - 0.8);
  }
  EXPECT_NEAR(line.loads[1].load_n[1], -about_first_nm / 0.7, 1e-8 * whole_n);
  EXPECT_NEAR(line.loads[0].load_n[1] + line.loads[1].load_n[1], -whole_n, 1e-8 * whole_n);
  EXPECT_NEAR(at(line, 0.8)[0].moment_nm[1], -beyond_nm, 1e-8 * whole_n);
  EXPECT_NEAR(at(line, length_m)[1].moment_nm[1], 0, 1e-8 * whole_n);
}

TEST(StaticLine, ASealHoldsNothingAndNameOrSoftnessTellIt) {
  model::RotorKit kit = uniform_shaft();
  const StaticLine bare = static_line(kit, {length_m / 2});
  model::Support seal = bearing_at(length_m / 2);
  seal.name = "SealElement_Seal 1";
  kit.supports.insert(kit.supports.begin(), seal);
  EXPECT_EQ(bearings_of(kit), (std::vector<std::size_t>{1, 2}));
  const StaticLine line = static_line(kit, {});
  EXPECT_NEAR(line.loads[0].load_n[1], bare.loads[0].load_n[1], 1e-6);
  kit.supports.front().name.clear();
  EXPECT_EQ(bearings_of(kit), (std::vector<std::size_t>{1, 0, 2}));
}

/// A pedestal on a mount that is a thousandth as stiff as the bearings carries their load all the same.
TEST(StaticLine, ASoftMountOfAHousingIsNoSeal) {
  model::RotorKit kit = uniform_shaft();
  kit.housings.push_back({.mass_kg = 3});
  kit.supports[1].on_housing = 0;
  model::Support mount = bearing_at(length_m);
  mount.stiffness_x_n_per_m = mount.stiffness_y_n_per_m = 1e-3 * bearing_n_per_m;
  mount.at_housing = 0;
  kit.supports.push_back(mount);
  const StaticLine line = static_line(kit, {}), held = static_line(uniform_shaft(), {});
  EXPECT_EQ(bearings_of(kit), (std::vector<std::size_t>{0, 1}));
  ASSERT_EQ(line.loads.size(), 2U);
  for (std::size_t i : {0U, 1U}) EXPECT_NEAR(line.loads[i].load_n[1], held.loads[i].load_n[1], 1e-6);
}

/// Rounding may leave a finite solution of the singular equations.
TEST(StaticLine, OneBearingBesideSealsHoldsNothing) {
  model::RotorKit kit = uniform_shaft();
  EXPECT_TRUE(static_line(kit, {}).holds);
  for (const double place_m : {0.0, 0.37, 0.9}) {
    kit.supports = {bearing_at(place_m), bearing_at(length_m)};
    kit.supports[1].name = "Seal";
    EXPECT_FALSE(static_line(kit, {}).holds) << place_m;
  }
  kit.supports[0].angular_stiffness_nm_per_rad = 1e5;
  EXPECT_TRUE(static_line(kit, {}).holds) << "clamped";
}

}  // namespace
}  // namespace rubsweep::design
