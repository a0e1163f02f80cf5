#include "rubsweep/core/structure/beam_element.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/structure/steel.hpp"
#include "core/structure/written_elements.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/spectral/decompositions.hpp"

namespace rubsweep::structure {
namespace {

TEST(BeamElementMesh, HasNodesAtPartsAndTwoAtACoupling) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.4, 0.02), steel_segment(0.6, 0.03)};
  kit.elements = 4;
  kit.discs = {{.position_m = 0.3}};
  kit.couplings = {{.position_m = 0.8}};
  const BeamMesh mesh = mesh_of(kit, {0.3 + 1e-12, 1});
  // The longest allowed element is 0.25 m: 0 to 0.3 and 0.4 to 0.8 are halved.
  const std::vector<double> expected{0, 0.15, 0.3, 0.4, 0.6, 0.8, 0.8, 1};
  ASSERT_EQ(mesh.node_position_m.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(mesh.node_position_m[i], expected[i], 1e-11) << i;
  ASSERT_EQ(mesh.elements.size(), 6U) << "none between the two ends of the coupling";
  EXPECT_EQ(mesh.elements[3].segment, &kit.shaft[1]);
  EXPECT_NEAR(mesh.elements[3].from, 0, 1e-15);
  EXPECT_NEAR(mesh.elements[3].to, 1.0 / 3, 1e-12);
  EXPECT_EQ(mesh.elements[5].first_node, 6U);
}

TEST(BeamElementMesh, TakesThePointsOfABow) {
  model::RotorKit kit;
  kit.bow = model::Bow{.shape = model::BowPoints{.position_m = {0.1, 0.7}, .deflection_m = {0, 1e-4}}};
  kit.sensors = {{.position_m = 0.2}};
  std::vector<double> places;
  add_places(kit, places);
  EXPECT_EQ(places, (std::vector<double>{0.2, 0.1, 0.7}));
}

using std::numbers::pi;

/// Natural frequencies in rad/s, ascending, of a line of equal elements; `fixed` coordinates are removed.
Eigen::VectorXd frequencies(const model::ShaftSegment& segment, int elements, const std::vector<int>& fixed) {
  const BeamElement beam = timoshenko_element(segment, segment.length_m / elements);
  const Eigen::Index n = 2 * (elements + 1);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n), stiffness = mass;
  for (int e = 0; e < elements; ++e) {
    mass.block<4, 4>(2 * e, 2 * e) += beam.mass;
    stiffness.block<4, 4>(2 * e, 2 * e) += beam.stiffness;
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (std::find(fixed.begin(), fixed.end(), static_cast<int>(i)) == fixed.end()) kept.push_back(i);
  }
  const Eigen::MatrixXd k = stiffness(kept, kept), m = mass(kept, kept);
  return numerics::spectral::generalized_eigenvalues(k, m).cwiseMax(0).cwiseSqrt();
}

/// Simply supported Timoshenko beam: lower root of rho^2 I / (k G) w^4 - (rho A + rho I (1 + E / (k G)) a^2)
/// w^2 + E I a^4 = 0 with a = n pi / L.
double simply_supported(const model::ShaftSegment& s, int mode) {
  const double area = section_area_m2(s), moment = section_moment_m4(s), rho = s.density_kg_per_m3;
  const double shear = shear_coefficient(s) * s.shear_modulus_pa, a = mode * pi / s.length_m;
  const double p = rho * rho * moment / shear;
  const double q = rho * area + rho * moment * (1 + s.youngs_modulus_pa / shear) * a * a;
  const double r = s.youngs_modulus_pa * moment * std::pow(a, 4);
  return std::sqrt(2 * r / (q + std::sqrt(q * q - 4 * p * r)));
}

TEST(BeamElementTimoshenko, SectionOfTubeAndRod) {
  const auto tube = steel_segment(1, 0.08, 0.03);
  EXPECT_NEAR(section_area_m2(tube), pi / 4 * (0.0064 - 0.0009), 1e-18);
  EXPECT_NEAR(section_moment_m4(tube), pi / 64 * (std::pow(0.08, 4) - std::pow(0.03, 4)), 1e-20);
  // Cowper's solid round section: 6 (1 + nu) / (7 + 6 nu).
  const double nu = 211.0 / 162.4 - 1;
  EXPECT_NEAR(shear_coefficient(steel_segment(1, 0.08)), 6 * (1 + nu) / (7 + 6 * nu), 1e-15);
  EXPECT_LT(shear_coefficient(tube), shear_coefficient(steel_segment(1, 0.08)));
}

TEST(BeamElementTimoshenko, RigidMotionIsFreeAndWeighsWhatTheBeamWeighs) {
  for (const double length : {0.01, 0.3}) {
    const auto segment = steel_segment(length, 0.05, 0.02);
    const BeamElement beam = timoshenko_element(segment, length);
    const Eigen::Vector4d shift(1, 0, 1, 0), tilt(-length / 2, 1, length / 2, 1);
    EXPECT_LT((beam.stiffness * shift).norm(), 1e-12 * beam.stiffness.norm());
    EXPECT_LT((beam.stiffness * tilt).norm(), 1e-12 * beam.stiffness.norm());
    const double mass = segment.density_kg_per_m3 * section_area_m2(segment) * length;
    const double moment = segment.density_kg_per_m3 * section_moment_m4(segment) * length;
    EXPECT_NEAR(shift.dot(beam.mass * shift), mass, 1e-13 * mass);
    EXPECT_NEAR(shift.dot(beam.mass * tilt), 0, 1e-13 * mass);
    const double about_diameter = mass * length * length / 12 + moment;
    EXPECT_NEAR(tilt.dot(beam.mass * tilt), about_diameter, 1e-13 * about_diameter);
    EXPECT_NEAR(tilt.dot(beam.gyroscopic * tilt), 2 * moment, 1e-12 * moment);
    EXPECT_EQ(beam.mass, beam.mass.transpose());
    EXPECT_EQ(beam.stiffness, beam.stiffness.transpose());
    EXPECT_EQ(beam.gyroscopic, beam.gyroscopic.transpose());
  }
}

TEST(BeamElementTimoshenko, OneElementBendsExactlyUnderEndLoads) {
  for (const double length : {0.05, 0.2, 2.0}) {
    const auto segment = steel_segment(length, 0.05);
    const BeamElement beam = timoshenko_element(segment, length);
    const double bending = segment.youngs_modulus_pa * section_moment_m4(segment);
    const double shear = shear_coefficient(segment) * segment.shear_modulus_pa * section_area_m2(segment);
    const Eigen::Matrix2d flexibility = beam.stiffness.bottomRightCorner<2, 2>().inverse();
    const double tip = std::pow(length, 3) / (3 * bending) + length / shear;
    EXPECT_NEAR(flexibility(0, 0), tip, 1e-12 * tip);
    EXPECT_NEAR(flexibility(0, 1), length * length / (2 * bending), 1e-12 * tip / length);
    EXPECT_NEAR(flexibility(1, 1), length / bending, 1e-12 * length / bending);
  }
}

std::vector<double> errors_of_8_16_32_elements(const model::ShaftSegment& segment, int mode) {
  std::vector<double> error;
  for (const int elements : {8, 16, 32}) {
    const auto w = frequencies(segment, elements, {0, 2 * elements});
    error.push_back(w(mode - 1) / simply_supported(segment, mode) - 1);
    EXPECT_GT(error.back(), -1e-9);  // a Galerkin frequency is an upper bound
  }
  return error;
}

TEST(BeamElementTimoshenko, SimplySupportedBeamConvergesWithFourthOrderInBendingAndSecondInShear) {
  for (const int mode : {1, 2, 3}) {
    const auto slender = errors_of_8_16_32_elements(steel_segment(2, 0.002), mode);
    EXPECT_NEAR(std::log2(slender[0] / slender[1]), 4, 0.2) << mode;
    EXPECT_LT(slender[2], 1e-5) << mode;
    const auto thick = errors_of_8_16_32_elements(steel_segment(1, 0.2), mode);
    EXPECT_NEAR(std::log2(thick[0] / thick[1]), 2, 0.1) << mode;
    EXPECT_NEAR(std::log2(thick[1] / thick[2]), 2, 0.1) << mode;
    EXPECT_LT(thick[2], 1.5e-3) << mode;
  }
}

TEST(BeamElementTimoshenko, SlenderCantileverAndFreeBeamAreThoseOfEuler) {
  // First roots of cosh b cos b = -1 (cantilever) and of cosh b cos b = 1 (free).
  const double cantilever[] = {1.8751040687119611, 4.694091132974175, 7.854757438237613};
  const double free[] = {4.730040744862704, 7.853204624095838, 10.995607838001671};
  const auto segment = steel_segment(2, 0.002);
  const double bending = segment.youngs_modulus_pa * section_moment_m4(segment);
  const double per_length = segment.density_kg_per_m3 * section_area_m2(segment);
  const double unit = std::sqrt(bending / per_length) / (segment.length_m * segment.length_m);
  const auto clamped = frequencies(segment, 24, {0, 1});
  const auto loose = frequencies(segment, 24, {});
  for (int mode = 0; mode < 3; ++mode) {
    EXPECT_NEAR(clamped(mode) / (cantilever[mode] * cantilever[mode] * unit), 1, 2e-5);
    EXPECT_NEAR(loose(mode + 2) / (free[mode] * free[mode] * unit), 1, 4e-5);
  }
  EXPECT_LT(loose(1), 1e-3 * loose(2));  // two rigid motions
}

TEST(BeamElementShearCoefficient, OfHutchinsonIsThePublishedOne) {
  auto segment = steel_segment(1, 0.08);
  segment.shear_modulus_pa = segment.youngs_modulus_pa / 2.6;  // nu = 0.3
  segment.shear_coefficient = model::ShearCoefficient::hutchinson;
  EXPECT_NEAR(shear_coefficient(segment), 6 * 1.69 / (7 + 3.6 + 0.36), 1e-14);
  // A thin tube: (1 + nu) / (2 + nu).
  segment.inner_diameter_m = 0.08 * (1 - 1e-7);
  EXPECT_NEAR(shear_coefficient(segment), 1.3 / 2.3, 1e-6);
}

/// An Euler beam without rotary inertia, as in textbooks.
model::ShaftSegment euler(double length_m) {
  auto segment = steel_segment(length_m, 0.05);
  segment.shear_coefficient = model::ShearCoefficient::none;
  segment.rotary_inertia = segment.gyroscopic = false;
  return segment;
}

Eigen::Matrix4d euler_mass(const model::ShaftSegment& s) {
  const double l = s.length_m;
  Eigen::Matrix4d m;
  m << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l,
      -3 * l * l, -22 * l, 4 * l * l;
  return s.density_kg_per_m3 * pi / 4 * 0.05 * 0.05 * l / 420 * m;
}

Eigen::Matrix4d euler_stiffness(const model::ShaftSegment& s) {
  const double l = s.length_m;
  Eigen::Matrix4d k;
  k << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l,
      -6 * l, 4 * l * l;
  return s.youngs_modulus_pa * pi / 64 * std::pow(0.05, 4) / (l * l * l) * k;
}

TEST(BeamElementTimoshenko, WithoutShearAndRotaryInertiaIsEulersMatrixWrittenDown) {
  auto segment = euler(0.3);
  segment.mass_damping_per_s = 0.7;
  segment.stiffness_damping_s = 2e-5;
  const BeamElement beam = timoshenko_element(segment, 0.3);
  EXPECT_LT((beam.mass - euler_mass(segment)).norm(), 1e-14 * beam.mass.norm());
  EXPECT_LT((beam.stiffness - euler_stiffness(segment)).norm(), 1e-14 * beam.stiffness.norm());
  const Eigen::Matrix4d damping = 0.7 * euler_mass(segment) + 2e-5 * euler_stiffness(segment);
  EXPECT_LT((beam.damping - damping).norm(), 1e-14 * damping.norm());
  EXPECT_EQ(beam.gyroscopic, Eigen::Matrix4d(Eigen::Matrix4d::Zero()));
}

TEST(BeamElementTimoshenko, TheTwoFlagsOfTheRotationAreApart) {
  auto segment = euler(0.3);
  segment.gyroscopic = true;
  const BeamElement turning = timoshenko_element(segment, 0.3);
  EXPECT_LT((turning.mass - euler_mass(segment)).norm(), 1e-14 * turning.mass.norm());
  segment.rotary_inertia = true;
  segment.gyroscopic = false;
  const BeamElement heavy = timoshenko_element(segment, 0.3);
  EXPECT_LT((heavy.mass - euler_mass(segment) - turning.gyroscopic / 2).norm(), 1e-14 * heavy.mass.norm());
  EXPECT_EQ(heavy.gyroscopic, Eigen::Matrix4d(Eigen::Matrix4d::Zero()));
}

TEST(BeamElementLayered, ARodInATubeIsTheRodThatTheyMake) {
  model::ShaftSegment whole = steel_segment(0.2, 0.08);
  whole.shear_coefficient = model::ShearCoefficient::none;
  model::ShaftSegment parts = whole;
  parts.outer_diameter_m = 0.05;
  model::ShaftLayer tube = whole;
  tube.inner_diameter_m = 0.05;
  parts.layers.push_back(tube);
  const BeamElement one = layered_element(whole, 0.2, 0, 1), two = layered_element(parts, 0.2, 0, 1);
  EXPECT_LT((one.mass - two.mass).norm(), 1e-14 * one.mass.norm());
  EXPECT_LT((one.stiffness - two.stiffness).norm(), 1e-14 * one.stiffness.norm());
  EXPECT_LT((one.gyroscopic - two.gyroscopic).norm(), 1e-14 * one.gyroscopic.norm());
  EXPECT_NEAR(one.polar_inertia_kg_m2, two.polar_inertia_kg_m2, 1e-14 * one.polar_inertia_kg_m2);
}

TEST(BeamElementTimoshenko, StiffnessDiametersBendAndTheOthersWeigh) {
  const auto thin = steel_segment(0.2, 0.05, 0.01), thick = steel_segment(0.2, 0.08);
  auto apart = thick;
  apart.stiffness_outer_diameter_m = 0.05;
  apart.stiffness_inner_diameter_m = 0.01;
  const BeamElement beam = timoshenko_element(apart, 0.2);
  EXPECT_LT((beam.stiffness - timoshenko_element(thin, 0.2).stiffness).norm(), 1e-14 * beam.stiffness.norm());
  const Eigen::Vector4d shift(1, 0, 1, 0);
  const double mass = thick.density_kg_per_m3 * pi / 4 * 0.08 * 0.08 * 0.2;
  EXPECT_NEAR(shift.dot(beam.mass * shift), mass, 1e-13 * mass);
}

model::ShaftSegment printed_taper() {
  auto segment = steel_segment(0.5, 0.1, 0.05);
  segment.outer_diameter_end_m = 0.15;
  return segment;
}

/// Element printed in the documentation of ROSS (github.com/petrobras/ross), ross/shaft_element.py. The
/// stiffness is integrated by the midpoint rule with 2000 points over the true section; for the shear ROSS
/// used the section at the left end.
TEST(BeamElementTimoshenko, ATaperIsThePrintedOne) {
  const BeamElement beam = timoshenko_element(printed_taper(), 0.5);
  EXPECT_NEAR(beam.mass(0, 0), 11.36986417, 5e-9);
  EXPECT_NEAR(beam.mass(0, 1), 0.86197637, 5e-9);
  EXPECT_NEAR(beam.mass(1, 1), 0.08667495, 5e-9);
  EXPECT_NEAR(beam.gyroscopic(0, 0), 0.30940809, 5e-9);
  EXPECT_NEAR(beam.gyroscopic(0, 1), 0.01085902, 5e-9);
  EXPECT_NEAR(beam.gyroscopic(1, 1), 0.0067206, 5e-9);
  EXPECT_NEAR(beam.stiffness(0, 0), 219.9613836e6, 1e3);
  EXPECT_NEAR(beam.stiffness(0, 1), 41.29753505e6, 1e2);
  EXPECT_NEAR(beam.stiffness(1, 1), 12.23526167e6, 1e2);
}

TEST(BeamElementTimoshenko, ATaperThatDoesNotTaperIsTheStraightOne) {
  const auto straight = steel_segment(0.2, 0.08, 0.03);
  auto taper = straight;
  taper.outer_diameter_end_m = 0.08;
  taper.inner_diameter_end_m = 0.03;
  const BeamElement a = timoshenko_element(straight, 0.2), b = timoshenko_element(taper, 0.2);
  EXPECT_LT((a.mass - b.mass).norm(), 1e-13 * a.mass.norm());
  EXPECT_LT((a.gyroscopic - b.gyroscopic).norm(), 1e-13 * a.gyroscopic.norm());
  EXPECT_LT((a.stiffness - b.stiffness).norm(), 1e-13 * a.stiffness.norm());
  EXPECT_NEAR(a.polar_inertia_kg_m2, b.polar_inertia_kg_m2, 1e-13 * a.polar_inertia_kg_m2);
}

/// Parts of a solid cone have the same tip compliance as the whole cone: 64 F l^3 / (3 pi E d^3 D) by bending
/// and 4 F l / (pi k G d D) by shear. The cone is clamped at its thick end D.
TEST(BeamElementTimoshenko, PartsOfATaperBendAsTheCone) {
  auto cone = steel_segment(0.4, 0.06);
  cone.outer_diameter_end_m = 0.03;
  constexpr int parts = 64;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * parts + 2, 2 * parts + 2);
  for (int i = 0; i < parts; ++i) {
    stiffness.block<4, 4>(2 * i, 2 * i) +=
        timoshenko_element(cone, 0.4 / parts, double(i) / parts, double(i + 1) / parts).stiffness;
  }
  const Eigen::VectorXd at_the_tip = Eigen::VectorXd::Unit(2 * parts, 2 * parts - 2);
  const Eigen::VectorXd deflection =
      numerics::dense::solve(stiffness.bottomRightCorner(2 * parts, 2 * parts), at_the_tip);
  const double bending = 64 * std::pow(0.4, 3) / (3 * pi * 211e9 * std::pow(0.06, 3) * 0.03);
  const double shear = 4 * 0.4 / (pi * shear_coefficient(cone) * 81.2e9 * 0.06 * 0.03);
  EXPECT_NEAR(deflection(2 * parts - 2), bending + shear, 2e-4 * (bending + shear));
}

void expect_written(const BeamElement& beam, const WrittenElement& written) {
  const Eigen::Matrix4d mass = written.translation + written.rotary, gyroscopic = 2 * written.rotary;
  EXPECT_LT((beam.mass - mass).norm(), 1e-13 * mass.norm());
  EXPECT_LT((beam.gyroscopic - gyroscopic).norm(), 1e-12 * gyroscopic.norm());
  EXPECT_LT((beam.stiffness - written.stiffness).norm(), 1e-13 * written.stiffness.norm());
}

model::ShaftSegment tube(model::ShearCoefficient coefficient = model::ShearCoefficient::cowper) {
  auto segment = steel_segment(0.3, 0.05, 0.02);
  segment.shear_coefficient = coefficient;
  return segment;
}

TEST(BeamElementTimoshenko, WithEitherShearCoefficientIsTheMatrixWrittenDown) {
  expect_written(timoshenko_element(tube(), 0.3), written_tube);
  expect_written(timoshenko_element(tube(model::ShearCoefficient::hutchinson), 0.3), written_hutchinson_tube);
}

TEST(BeamElementTimoshenko, ATaperIsTheMatrixWrittenDown) {
  auto taper = steel_segment(0.3, 0.06, 0.01);
  taper.outer_diameter_end_m = 0.04;
  taper.inner_diameter_end_m = 0.02;
  expect_written(timoshenko_element(taper, 0.3), written_taper);
}

/// Each section has its own flags and damping: the sleeve has no rotary inertia and mass-proportional
/// damping; the tube has no gyroscopic moment and stiffness-proportional damping.
TEST(BeamElementLayered, ATubeInASleeveIsTheSumWrittenDown) {
  auto segment = tube();
  segment.gyroscopic = false;
  segment.stiffness_damping_s = 3e-6;
  model::ShaftLayer sleeve = steel_segment(0.3, 0.08, 0.05);
  sleeve.youngs_modulus_pa = 70e9;
  sleeve.shear_modulus_pa = 26e9;
  sleeve.density_kg_per_m3 = 2700;
  sleeve.rotary_inertia = false;
  sleeve.mass_damping_per_s = 0.8;
  segment.layers.push_back(sleeve);
  const BeamElement beam = layered_element(segment, 0.3, 0, 1);
  const Eigen::Matrix4d mass = written_tube.translation + written_tube.rotary + written_sleeve.translation;
  const Eigen::Matrix4d stiffness = written_tube.stiffness + written_sleeve.stiffness;
  const Eigen::Matrix4d damping = 3e-6 * written_tube.stiffness + 0.8 * written_sleeve.translation;
  const Eigen::Matrix4d gyroscopic = 2 * written_sleeve.rotary;
  EXPECT_LT((beam.mass - mass).norm(), 1e-13 * mass.norm());
  EXPECT_LT((beam.stiffness - stiffness).norm(), 1e-13 * stiffness.norm());
  EXPECT_LT((beam.damping - damping).norm(), 1e-13 * damping.norm());
  EXPECT_LT((beam.gyroscopic - gyroscopic).norm(), 1e-12 * gyroscopic.norm());
}

}  // namespace

}  // namespace rubsweep::structure
