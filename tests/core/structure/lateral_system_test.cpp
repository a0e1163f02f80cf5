#include "rubsweep/core/structure/lateral_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "core/structure/steel.hpp"
#include "core/structure/whirl_eigenvalues.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/beam_element.hpp"
#include "rubsweep/core/structure/free_modes.hpp"

namespace rubsweep::structure {
namespace {

using std::numbers::pi;

/// Whirl frequencies in rad/s at a shaft speed, ascending.
Eigen::VectorXd whirl_rad_per_s(const LateralSystem& system, double speed_rad_per_s) {
  const std::vector<std::complex<double>> values = whirl_eigenvalues(system, speed_rad_per_s);
  return Eigen::Map<const Eigen::VectorXcd>(values.data(), static_cast<Eigen::Index>(values.size())).imag();
}

Eigen::VectorXd whirl(const model::RotorKit& kit, double rpm) {
  return whirl_rad_per_s(full(kit), rpm * pi / 30);
}

/// A disc of the shaft's steel on a shaft of 50 mm diameter.
model::Disc keyed_disc(double position_m, double diameter_m, double width_m) {
  const double hole = 0.05, area = pi / 4 * (diameter_m * diameter_m - hole * hole);
  const double polar = pi / 32 * (std::pow(diameter_m, 4) - std::pow(hole, 4)) * 7810 * width_m;
  const double mass = 7810 * area * width_m;
  return {.position_m = position_m,
          .mass_kg = mass,
          .polar_inertia_kg_m2 = polar,
          .diametral_inertia_kg_m2 = polar / 2 + mass * width_m * width_m / 12};
}

/// Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010), example 5.9.1: two discs on a shaft
/// of 1.5 m in six elements.
model::RotorKit two_discs(double stiffness_x, double stiffness_y) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(1.5, 0.05)};
  kit.discs = {keyed_disc(0.5, 0.28, 0.07), keyed_disc(1, 0.35, 0.07)};
  kit.supports = {isotropic_support(0, stiffness_x), isotropic_support(1.5, stiffness_x)};
  for (auto& support : kit.supports) support.stiffness_y_n_per_m = stiffness_y;
  kit.elements = 6;
  return kit;
}

void expect_lowest(const Eigen::VectorXd& found, const std::vector<double>& printed, double relative) {
  ASSERT_GE(found.size(), static_cast<Eigen::Index>(printed.size()));
  for (std::size_t i = 0; i < printed.size(); ++i) {
    EXPECT_NEAR(found(static_cast<Eigen::Index>(i)), printed[i], relative * printed[i]) << i;
  }
}

TEST(LateralSystemWhirlFrequencies, OfTheTwoDiscRotorAsRossPrintsThem) {
  // ROSS (github.com/petrobras/ross), docs/examples/example_05_09_01.rst, rad/s.
  expect_lowest(whirl(two_discs(1e6, 1e6), 0),
                {86.65811435, 86.65811435, 274.31285391, 274.31285391, 716.78631221, 716.78631221}, 2e-7);
  expect_lowest(whirl(two_discs(1e6, 1e6), 4000),
                {85.389467, 87.7958637, 251.78460413, 294.71333087, 600.17936195, 827.07536193}, 2e-7);
}

TEST(LateralSystemWhirlFrequencies, OfAnisotropicBearingsAsTheBookPrintsThem) {
  // Example 5.9.2 of the same book, with 0.8 MN/m in y; four digits.
  expect_lowest(whirl(two_discs(1e6, 0.8e6), 0), {82.65, 86.66, 254.52, 274.31, 679.49, 716.79}, 1e-4);
  expect_lowest(whirl(two_discs(1e6, 0.8e6), 4000), {82.33, 86.86, 239.64, 287.25, 583.49, 806.89}, 1e-4);
}

TEST(LateralSystemWhirlFrequencies, OfTheOverhungRotorAsTheBookPrintsThem) {
  // Example 5.9.9: bearings at 0 and 1 m, disc at the end; four digits (ROSS, ross/tests/test_examples.py).
  model::RotorKit kit;
  kit.shaft = {steel_segment(1.5, 0.05)};
  kit.discs = {keyed_disc(1.5, 0.35, 0.07)};
  kit.supports = {isotropic_support(0, 1e7), isotropic_support(1, 1e7)};
  kit.elements = 6;
  expect_lowest(whirl(kit, 0), {90.14, 90.14, 630.73, 630.73, 830.43, 830.43}, 1e-3);
  expect_lowest(whirl(kit, 4000), {76.19, 103.91, 565.99, 634.23, 647.75, 1174.2}, 1e-3);
}

TEST(LateralSystemWhirlFrequencies, OverhungDiscOnALightShaftSplitsAsItsClosedForm) {
  model::RotorKit kit;
  auto segment = steel_segment(0.4, 0.02);
  segment.density_kg_per_m3 = 1e-6;
  kit.shaft = {segment};
  const double m = 3, polar = 0.02, diametral = 0.011, l = 0.4, k = 1e7, k_tilt = 1e6;
  kit.discs = {
      {.position_m = l, .mass_kg = m, .polar_inertia_kg_m2 = polar, .diametral_inertia_kg_m2 = diametral}};
  kit.supports = {isotropic_support(0, k)};
  kit.supports[0].angular_stiffness_nm_per_rad = k_tilt;
  kit.elements = 3;
  const double bending = segment.youngs_modulus_pa * section_moment_m4(segment);
  const double shear = shear_coefficient(segment) * segment.shear_modulus_pa * section_area_m2(segment);
  Eigen::Matrix2d flexibility;
  flexibility << l * l * l / (3 * bending) + l / shear + 1 / k + l * l / k_tilt,
      l * l / (2 * bending) + l / k_tilt, l * l / (2 * bending) + l / k_tilt, l / bending + 1 / k_tilt;
  const Eigen::Matrix2d stiffness = flexibility.inverse();
  const double speed = 700;
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const PlaneModes modes = plane_modes(shaft.mass, shaft.plane_stiffness(0), 2);  // all modes with mass
  const LateralSystem system = project(shaft, {modes.shape, modes.shape});
  const Eigen::VectorXd found = whirl_rad_per_s(system, speed);
  ASSERT_EQ(found.size(), 4);
  for (int i = 0; i < 4; ++i) {
    const auto characteristic = [&](double w) {
      return (stiffness(0, 0) - m * w * w) * (stiffness(1, 1) - diametral * w * w + polar * speed * w) -
             stiffness(0, 1) * stiffness(1, 0);
    };
    // Forward whirl (w > 0) or backward whirl (w < 0): a change of sign nearby shows that w is a root.
    const double w = found(i);
    const auto changes = [&](double sign) {
      return characteristic(sign * w * (1 - 1e-7)) * characteristic(sign * w * (1 + 1e-7)) < 0;
    };
    EXPECT_TRUE(changes(1) != changes(-1)) << w;
  }
  // Forward whirl is faster than at rest, backward slower.
  const Eigen::VectorXd rest = whirl_rad_per_s(system, 0);
  EXPECT_LT(found(0), rest(0) * 0.99);
  EXPECT_GT(found(1), rest(0) * 1.01);
}

TEST(LateralSystemPlaneModes, AreOrthogonalAndSolveTheProblem) {
  const BeamShaft shaft = assemble_beam_shaft(two_discs(1e6, 1e6), {});
  const Eigen::MatrixXd stiffness = shaft.plane_stiffness(0);
  const PlaneModes modes = plane_modes(shaft.mass, stiffness, 5);
  ASSERT_EQ(modes.rad_per_s.size(), 5);
  const Eigen::MatrixXd unit = modes.shape.transpose() * shaft.mass * modes.shape;
  EXPECT_LT((unit - Eigen::MatrixXd::Identity(5, 5)).norm(), 1e-9);
  for (Eigen::Index j = 0; j < 5; ++j) {
    const double w = modes.rad_per_s(j);
    const Eigen::VectorXd rest = stiffness * modes.shape.col(j) - w * w * shaft.mass * modes.shape.col(j);
    EXPECT_LT(rest.norm(), 1e-9 * (stiffness * modes.shape.col(j)).norm() + 1e-9 * stiffness.norm() * 1e-6)
        << j;
  }
}

TEST(LateralSystemPlaneModes, RefuseAShaftThatNothingHolds) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(1, 0.02)};
  kit.supports = {isotropic_support(0.5, 1e6)};
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  Eigen::MatrixXd loose = shaft.elastic;
  EXPECT_THROW(
      plane_modes(shaft.mass, loose - 1e-3 * Eigen::MatrixXd::Identity(loose.rows(), loose.cols()), 3),
      ConfigError);
}

TEST(LateralSystemProject, EqualPlanesArePairsToTheLastBit) {
  const BeamShaft shaft = assemble_beam_shaft(two_discs(1e6, 1e6), {});
  const PlaneModes modes = plane_modes(shaft.mass, shaft.plane_stiffness(0), 4);
  const LateralSystem system = project(shaft, {modes.shape, modes.shape});
  for (Eigen::Index r = 0; r < 8; r += 2) {
    for (Eigen::Index c = 0; c < 8; c += 2) {
      EXPECT_EQ(system.stiffness(r, c), system.stiffness(r + 1, c + 1));
      EXPECT_EQ(system.mass(r, c), system.mass(r + 1, c + 1));
      EXPECT_EQ(system.stiffness(r, c + 1), 0);
      EXPECT_EQ(system.gyroscopic(r, c + 1), -system.gyroscopic(r + 1, c));
    }
  }
}

TEST(LateralSystemProject, CrossTermsKeepTheirPlaces) {
  model::RotorKit kit = two_discs(1e6, 0.8e6);
  kit.supports[0].stiffness_xy_n_per_m = 3e5;
  kit.supports[0].stiffness_yx_n_per_m = -2e5;
  kit.supports[1].damping_yx_ns_per_m = 70;
  const LateralSystem system = full(kit);
  EXPECT_EQ(system.stiffness(0, 1), 3e5);
  EXPECT_EQ(system.stiffness(1, 0), -2e5);
  const Eigen::Index last = 2 * (2 * 7 - 2);  // deflection of the last of seven nodes in the x plane
  EXPECT_EQ(system.damping(last + 1, last), 70);
  EXPECT_EQ(system.damping(last, last + 1), 0);
}

TEST(LateralSystemPlaneModes, NumbersWithoutModesAreRefused) {
  const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
  const auto message = [](const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness) {
    return message_of<ConfigError>([&] { plane_modes(mass, stiffness, 2); });
  };
  EXPECT_NE(message(std::numeric_limits<double>::infinity() * one, one).find("no finite number"),
            std::string::npos);
  EXPECT_NE(message(one, -one).find("leave the shaft free"), std::string::npos);
  EXPECT_NE(message(0 * one, one).find("too far apart to have modes"), std::string::npos);
}

/// An overhung disc with unequal dampers, a destabilising seal, and a constant or tabulated bearing.
model::RotorKit seal_kit() {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.3, 0.02), steel_segment(0.2, 0.015)};
  kit.discs = {
      {.position_m = 0.4, .mass_kg = 2, .polar_inertia_kg_m2 = 4e-3, .diametral_inertia_kg_m2 = 2e-3}};
  kit.supports = {isotropic_support(0, 4e6), isotropic_support(0.5, 1e6)};
  kit.supports[0].damping_x_ns_per_m = 700;
  kit.supports[1].damping_y_ns_per_m = 40;
  kit.supports[1].stiffness_xy_n_per_m = 2e5;
  kit.supports[1].stiffness_yx_n_per_m = -2e5;
  kit.elements = 10;
  return kit;
}

TEST(LateralSystemFullSystem, RatesAreTheWhirlEigenvalues) {
  const model::RotorKit kit = seal_kit();
  const FullSystem full_matrices = full_system(assemble_beam_shaft(kit, {}), kit);
  for (const double speed : {0.0, 2 * pi * 300}) {
    const double radius = 2 * pi * 3000;
    const Eigen::VectorXcd found = free_modes(matrices_at(full_matrices, speed), {0, radius}).rate_per_s;
    int within = 0;
    for (const auto& rate : whirl_eigenvalues(full(kit), speed)) {
      if (std::abs(rate) > radius) continue;
      ++within;
      EXPECT_LT((found.array() - rate).abs().minCoeff(), 1e-7 * std::abs(rate)) << rate;
    }
    EXPECT_GE(within, 6);
    EXPECT_GE(found.size(), 2 * within);
    EXPECT_GT(found.real().maxCoeff(), 1);  // the seal makes a whirl grow
  }
}

TEST(LateralSystemFullSystem, EveryModeHasItsStructuralDamping) {
  model::RotorKit kit = seal_kit();
  kit.supports = {isotropic_support(0, 4e6), isotropic_support(0.5, 1e6)};
  kit.damping_ratio = {0.05, 0.02, 0.3};
  const FullSystem full_matrices = full_system(assemble_beam_shaft(kit, {}), kit);
  const PlaneModes modes = plane_modes(assemble_beam_shaft(kit, {}).plane_mass(0),
                                       assemble_beam_shaft(kit, {}).plane_stiffness(0), 5);
  const Eigen::VectorXcd found =
      free_modes(matrices_at(full_matrices, 0), {0, 1.01 * modes.rad_per_s(4)}).rate_per_s;
  const double ratios[] = {0.05, 0.02, 0.3, 0.3, 0.3};
  for (Eigen::Index j = 0; j < 5; ++j) {
    const double z = ratios[j];
    const std::complex<double> rate = modes.rad_per_s(j) * std::complex<double>(-z, std::sqrt(1 - z * z));
    EXPECT_LT((found.array() - rate).abs().minCoeff(), 1e-8 * std::abs(rate)) << j;
  }
}

TEST(LateralSystemFullSystem, DampingThatTurnsMakesTheFirstWhirlGrowAboveItsSpeed) {
  model::RotorKit kit = seal_kit();
  kit.supports = {isotropic_support(0, 4e6), isotropic_support(0.5, 1e6)};
  for (auto& disc : kit.discs) disc.polar_inertia_kg_m2 = 0;
  for (auto& segment : kit.shaft) segment.density_kg_per_m3 = 1e-3;  // no gyroscopic moment
  kit.rotating_damping_ratio = {0.01};
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const FullSystem full_matrices = full_system(shaft, kit);
  const double first = plane_modes(shaft.plane_mass(0), shaft.plane_stiffness(0), 1).rad_per_s(0);
  for (const double speed : {0.99 * first, 1.01 * first}) {
    const double growth =
        free_modes(matrices_at(full_matrices, speed), {0, 1.5 * first}).rate_per_s.real().maxCoeff();
    EXPECT_EQ(growth > 0, speed > first) << speed / first;
  }
}

TEST(LateralSystemFullSystem, TablesAddWhatTheMiddleSpeedLacks) {
  model::RotorKit kit = seal_kit();
  model::SupportTable table;
  table.speed_hz = {0, 100, 200};
  for (auto& column : table.columns) column = {0, 0, 0};
  table.columns[0] = {1e6, 2e6, 4e6};
  table.columns[3] = {1e6, 2e6, 3e6};
  model::Support support = isotropic_support(0.5, 1);
  kit.supports[1] = model::with_table(support, table);
  const FullSystem tabled = full_system(assemble_beam_shaft(kit, {}), kit);
  const SpeedMatrices found = matrices_at(tabled, 2 * pi * 200, 2 * pi * 200);
  kit.supports[1] = isotropic_support(0.5, 4e6);
  kit.supports[1].stiffness_y_n_per_m = 3e6;
  const SpeedMatrices typed = matrices_at(full_system(assemble_beam_shaft(kit, {}), kit), 2 * pi * 200);
  EXPECT_LT((found.stiffness - typed.stiffness).norm(), 1e-12 * typed.stiffness.norm());
  EXPECT_EQ(found.damping, typed.damping);
}

}  // namespace

}  // namespace rubsweep::structure
