#include "rubsweep/core/structure/beam_shaft.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "core/structure/steel.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_element.hpp"

namespace rubsweep::structure {
namespace {

/// A stepped, coupled shaft with all kinds of parts.
model::RotorKit everything() {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.3, 0.02), steel_segment(0.5, 0.03, 0.01), steel_segment(0.2, 0.02)};
  kit.discs = {
      {.position_m = 0.4, .mass_kg = 2, .polar_inertia_kg_m2 = 4e-3, .diametral_inertia_kg_m2 = 2.5e-3},
      {.position_m = 1, .mass_kg = 0.5, .polar_inertia_kg_m2 = 5e-4, .diametral_inertia_kg_m2 = 3e-4}};
  kit.supports = {isotropic_support(0.05, 1e6), isotropic_support(0.9, 2e6)};
  kit.supports[1].pedestal =
      model::Pedestal{.mass_kg = 3, .stiffness_x_n_per_m = 4e6, .stiffness_y_n_per_m = 5e6};
  kit.couplings = {
      {.position_m = 0.6, .lateral_stiffness_n_per_m = 1e7, .angular_stiffness_nm_per_rad = 1e3}};
  return kit;
}

TEST(BeamShaft, MassInertiaAndWeightAddUp) {
  const model::RotorKit kit = everything();
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  double mass = 2.5 + 3, polar = 4.5e-3;
  for (const auto& segment : kit.shaft) {
    mass += segment.density_kg_per_m3 * section_area_m2(segment) * segment.length_m;
    polar += 2 * segment.density_kg_per_m3 * section_moment_m4(segment) * segment.length_m;
  }
  double weight = 0;
  const auto on_shaft = static_cast<Eigen::Index>(2 * shaft.node_position_m.size());
  for (Eigen::Index i = 0; i < shaft.coordinates(); ++i) {
    if (i >= on_shaft || i % 2 == 0) weight += shaft.weight_kg(i);
  }
  EXPECT_NEAR(weight, mass, 1e-12 * mass);
  EXPECT_NEAR(shaft.polar_inertia_kg_m2, polar, 1e-12 * polar);
}

TEST(BeamShaft, MatricesAreSymmetricAndTheLooseShaftHasNoStiffness) {
  model::RotorKit kit = everything();
  kit.couplings.clear();
  kit.supports[1].pedestal.reset();
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  for (const Eigen::MatrixXd* matrix : {&shaft.mass, &shaft.gyroscopic, &shaft.elastic}) {
    EXPECT_LT((*matrix - matrix->transpose()).norm(), 1e-15 * matrix->norm());
  }
  EXPECT_GT(numerics::dense::self_adjoint_eigenvalues(shaft.mass)(0), 0);
  Eigen::VectorXd shift(shaft.coordinates()), tilt(shaft.coordinates());
  for (std::size_t node = 0; node < shaft.node_position_m.size(); ++node) {
    const auto w = static_cast<Eigen::Index>(2 * node);
    shift.segment<2>(w) << 1, 0;
    tilt.segment<2>(w) << shaft.node_position_m[node], 1;
  }
  EXPECT_LT((shaft.elastic * shift).norm(), 1e-9 * shaft.elastic.norm());
  EXPECT_LT((shaft.elastic * tilt).norm(), 1e-9 * shaft.elastic.norm());
}

TEST(BeamShaft, DeflectionsAreReciprocal) {
  const BeamShaft shaft = assemble_beam_shaft(everything(), {0.2, 0.77});
  const numerics::dense::CholeskyFactors factor(shaft.plane_stiffness(1));
  ASSERT_TRUE(factor.positive_definite());
  const Eigen::Index a = shaft.deflection(0.2), b = shaft.deflection(0.77);
  const Eigen::Index n = shaft.coordinates();
  const double ab = factor.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(n, b)))(a);
  const double ba = factor.solve(Eigen::VectorXd(Eigen::VectorXd::Unit(n, a)))(b);
  EXPECT_NEAR(ab, ba, 1e-9 * std::abs(ab));
}

TEST(BeamShaft, SagAndPointLoadAreExactAtEveryNode) {
  // A uniform shaft on springs k at its ends, under its weight and a force at a; the nodes may lie anywhere.
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.4, 0.01), steel_segment(0.16, 0.01)};
  const double l = 0.56, k = 1e5, a = 0.15, force = 7, g = 9.81;
  kit.supports = {isotropic_support(0, k), isotropic_support(l, k)};
  kit.elements = 5;
  const BeamShaft shaft = assemble_beam_shaft(kit, {a, 0.31});
  const auto& segment = kit.shaft[0];
  const double bending = segment.youngs_modulus_pa * section_moment_m4(segment);
  const double shear = shear_coefficient(segment) * segment.shear_modulus_pa * section_area_m2(segment);
  const double load = segment.density_kg_per_m3 * section_area_m2(segment) * g;
  Eigen::VectorXd right = g * shaft.weight_kg;
  right(shaft.deflection(a)) += force;
  const Eigen::VectorXd q = numerics::dense::CholeskyFactors(shaft.plane_stiffness(0)).solve(right);
  for (std::size_t node = 0; node < shaft.node_position_m.size(); ++node) {
    const double z = shaft.node_position_m[node];
    const double sag = load * z / (24 * bending) * (l * l * l - 2 * l * z * z + z * z * z) +
                       load * z * (l - z) / (2 * shear) + load * l / (2 * k);
    const double b = l - a, near = std::min(z, a), x = z < a ? z : l - z, c = z < a ? b : a;
    const double bent = force * c * x / (6 * l * bending) * (l * l - c * c - x * x) +
                        force / shear * near * (l - std::max(z, a)) / l;
    const double ends = force / k * (b / l * (1 - z / l) + a / l * z / l);
    EXPECT_NEAR(q(static_cast<Eigen::Index>(2 * node)), sag + bent + ends, 1e-9 * (sag + bent + ends)) << z;
  }
}

TEST(BeamShaft, UnbalanceOfDiscsKeepsItsPhases) {
  model::RotorKit kit = everything();
  kit.discs[0].eccentricity_ratio = 0.5;
  kit.discs[0].eccentricity_phase_deg = 90;
  kit.discs[1].eccentricity_ratio = 0;
  kit.discs[1].skew_rad_per_m = 3;
  kit.discs[1].skew_phase_deg = 180;
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  Eigen::VectorXcd expected = Eigen::VectorXcd::Zero(shaft.coordinates());
  expected(shaft.deflection(0.4)) = std::complex<double>(0, 2 * 0.5);
  expected(shaft.deflection(1) + 1) = -(3e-4 - 5e-4) * 3;
  EXPECT_LT((shaft.unbalance_kg - expected).norm(), 1e-15);
}

TEST(BeamShaft, LeastBentLineOfThreePointsIsTheBeamBentOverThem) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.5, 0.01)};
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0.5, 1e6)};
  const model::BowPoints points{.position_m = {0, 0.25, 0.5}, .deflection_m = {0, 1e-4, 0}};
  kit.bow = model::Bow{.shape = points};
  const BeamShaft shaft = assemble_beam_shaft(kit, {0.1});
  const Eigen::VectorXd line = least_bent_line(shaft, points);
  EXPECT_NEAR(line(shaft.deflection(0.25)), 1e-4, 1e-15);
  // Three-point bending with shear; the ratio of shear to bending in the middle is 12 E I / (k G A l^2).
  const auto& s = kit.shaft[0];
  const double p = 12 * s.youngs_modulus_pa * section_moment_m4(s) /
                   (shear_coefficient(s) * s.shear_modulus_pa * section_area_m2(s) * 0.25);
  const double x = 0.1 / 0.5, bent = 3 * x - 4 * x * x * x, sheared = 2 * x;
  EXPECT_NEAR(line(shaft.deflection(0.1)), 1e-4 * (bent + p * sheared) / (1 + p), 1e-12);
}

TEST(BeamShaft, CouplingOpensTheShaftByItsOwnFlexibility) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.2, 0.02), steel_segment(0.2, 0.02)};
  kit.supports = {isotropic_support(0, 1e8)};
  kit.supports[0].angular_stiffness_nm_per_rad = 1e6;
  const auto tip = [&] {
    const BeamShaft shaft = assemble_beam_shaft(kit, {});
    const Eigen::Index n = shaft.coordinates(), end = shaft.deflection(0.4);
    const Eigen::VectorXd force = Eigen::VectorXd::Unit(n, end);
    return numerics::dense::CholeskyFactors(shaft.plane_stiffness(0)).solve(force)(end);
  };
  const double whole = tip();
  kit.couplings = {
      {.position_m = 0.2, .lateral_stiffness_n_per_m = 1e6, .angular_stiffness_nm_per_rad = 1e4}};
  EXPECT_NEAR(tip(), whole + 1e-6 + 0.2 * 0.2 / 1e4, 1e-9 * whole);
}

/// A bearing on a housing on another housing on the ground, both with different masses in y, compared with a
/// hand-written matrix. The coordinates of the housings come last.
TEST(BeamShaft, AChainOfHousingsIsItsMatrixWrittenDown) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.5, 0.05)};
  kit.elements = 1;
  kit.housings = {{.mass_kg = 3, .mass_y_kg = 4}, {.mass_kg = 7}};
  kit.point_masses = {{.position_m = 0.5, .mass_kg = 2, .mass_y_kg = 5}};
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0, 2e6), isotropic_support(0, 4e6),
                  isotropic_support(0.5, 8e6)};
  kit.supports[0].on_housing = 0;
  kit.supports[1].at_housing = 0;
  kit.supports[1].on_housing = 1;
  kit.supports[2].at_housing = 1;
  kit.supports[0].stiffness_xy_n_per_m = 5e5;
  kit.supports[1].damping_y_ns_per_m = 30;
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  ASSERT_EQ(shaft.coordinates(), 6);  // two nodes with (w, s) each, and two housings
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6, 6), cross = stiffness, damping = stiffness;
  stiffness(0, 0) = 1e6;
  stiffness(0, 4) = stiffness(4, 0) = -1e6;
  stiffness(4, 4) = 1e6 + 2e6;
  stiffness(4, 5) = stiffness(5, 4) = -2e6;
  stiffness(5, 5) = 2e6 + 4e6;
  stiffness(2, 2) = 8e6;
  cross(0, 0) = cross(4, 4) = 5e5;
  cross(0, 4) = cross(4, 0) = -5e5;
  damping(4, 4) = damping(5, 5) = 30;
  damping(4, 5) = damping(5, 4) = -30;
  EXPECT_EQ(shaft.support_stiffness[0][0], stiffness);
  EXPECT_EQ(shaft.support_stiffness[1][1], stiffness);
  EXPECT_EQ(shaft.support_stiffness[0][1], cross);
  EXPECT_TRUE(shaft.support_stiffness[1][0].isZero(0));
  EXPECT_EQ(shaft.support_damping[1][1], damping);
  const Eigen::MatrixXd added_x = shaft.plane_mass(0) - shaft.mass,
                        added_y = shaft.plane_mass(1) - shaft.mass;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(6), y = x;
  x << 0, 0, 2, 0, 3, 7;
  y << 0, 0, 5, 0, 4, 7;
  EXPECT_LT((added_x - Eigen::MatrixXd(x.asDiagonal())).norm(), 1e-13);
  EXPECT_LT((added_y - Eigen::MatrixXd(y.asDiagonal())).norm(), 1e-13);
  EXPECT_NEAR(shaft.weight_kg(4), 4, 1e-13);  // gravity pulls along y
}

TEST(BeamShaft, MaterialDampingIsThatOfItsElements) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.2, 0.05), steel_segment(0.3, 0.05)};
  kit.shaft[0].mass_damping_per_s = 2;
  kit.shaft[1].stiffness_damping_s = 1e-4;
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0.5, 1e6)};
  kit.elements = 1;
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  Eigen::MatrixXd damping = Eigen::MatrixXd::Zero(6, 6);
  damping.topLeftCorner<4, 4>() += 2 * timoshenko_element(kit.shaft[0], 0.2).mass;
  damping.bottomRightCorner<4, 4>() += 1e-4 * timoshenko_element(kit.shaft[1], 0.3).stiffness;
  EXPECT_LT((shaft.damping - damping).norm(), 1e-12 * damping.norm());
}

TEST(BeamShaft, ATaperIsCutWhereANodeStands) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.1, 0.06), steel_segment(0.4, 0.06)};
  kit.shaft[1].outer_diameter_end_m = 0.02;
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0.5, 1e6)};
  kit.elements = 1;
  const BeamShaft shaft = assemble_beam_shaft(kit, {0.2});
  const BeamElement end = timoshenko_element(kit.shaft[1], 0.3, 0.25, 1);
  EXPECT_LT((shaft.elastic.bottomRightCorner<2, 2>() - end.stiffness.bottomRightCorner<2, 2>()).norm(),
            1e-12 * end.stiffness.norm());
}

TEST(BeamShaft, AStationWithoutNodeIsAnError) {
  EXPECT_THROW(assemble_beam_shaft(everything(), {}).deflection(0.4321), SolverError);
}

}  // namespace

}  // namespace rubsweep::structure
