#include "rubsweep/core/structure/coupling_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "core/structure/steel.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"

namespace rubsweep::structure {
namespace {

using Complex = std::complex<double>;

/// Two shafts joined by a coupling at 0.2 m, each on its own bearings.
model::RotorKit two_shafts(const model::Coupling& coupling) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.2, 0.02), steel_segment(0.3, 0.02)};
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0.15, 1e6), isotropic_support(0.25, 1e6),
                  isotropic_support(0.5, 1e6)};
  kit.couplings = {coupling};
  return kit;
}

constexpr double lateral = 1e7, angular = 1e4;

/// With an eccentric coupling, the second shaft rests beside the first one.
TEST(CouplingLoads, CouplingsOutOfLineRestWithTheirEndsApart) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.2, 0.02), steel_segment(0.3, 0.02)};
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0.5, 1e6)};
  kit.couplings = {{.position_m = 0.2,
                    .lateral_stiffness_n_per_m = 1e7,
                    .angular_stiffness_nm_per_rad = 1e4,
                    .parallel_offset_m = 1e-4,
                    .parallel_phase_deg = 90,
                    .angular_offset_rad = 2e-3,
                    .angular_phase_deg = 180}};
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  Eigen::VectorXcd line = Eigen::VectorXcd::Zero(shaft.coordinates());
  const Eigen::Index behind = shaft.deflection(0.2) + 2;
  for (Eigen::Index w = behind; w < shaft.coordinates(); w += 2) {
    line(w) =
        std::complex<double>(-2e-3 * (shaft.node_position_m[static_cast<std::size_t>(w / 2)] - 0.2), 1e-4);
    line(w + 1) = -2e-3;
  }
  const Eigen::VectorXcd load = misalignment_load(shaft, kit);
  EXPECT_LT((shaft.elastic * line - load).norm(), 1e-9 * load.norm());
}

/// If the coupling deforms without force, each shaft rests on its own axis.
TEST(CouplingLoads, MachinesOutOfLinePullTheEndsTowardsEachOther) {
  const model::RotorKit kit = two_shafts({.position_m = 0.2,
                                          .lateral_stiffness_n_per_m = lateral,
                                          .angular_stiffness_nm_per_rad = angular,
                                          .parallel_misalignment_m = 1e-4,
                                          .parallel_misalignment_angle_deg = 30,
                                          .angular_misalignment_rad = 2e-3,
                                          .angular_misalignment_angle_deg = 90});
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const Eigen::VectorXcd load = standing_misalignment_load(shaft, kit);
  // In a common frame both shafts form one line: positions of the second shaft, relative to its own axis, are
  // shifted by the misalignment.
  const Eigen::Index behind = shaft.deflection(0.2) + 2;
  Eigen::VectorXcd offset = Eigen::VectorXcd::Zero(shaft.coordinates());
  for (Eigen::Index w = behind; w < shaft.coordinates(); w += 2) {
    offset(w) = std::polar(1e-4, std::numbers::pi / 6) +
                Complex(0, 2e-3 * (shaft.node_position_m[static_cast<std::size_t>(w / 2)] - 0.2));
    offset(w + 1) = Complex(0, 2e-3);
  }
  EXPECT_LT((shaft.elastic * offset + load).norm(), 1e-9 * load.norm());
}

/// Energy of a spring k (1 + ratio) along a rotated axis, differentiated by hand: rotate, multiply, rotate
/// back.
TEST(CouplingLoads, AnAsymmetricCouplingPushesAsASpringThatTurns) {
  const double ratio = 0.1, axis_deg = 25;
  const model::RotorKit kit = two_shafts({.position_m = 0.2,
                                          .lateral_stiffness_n_per_m = lateral,
                                          .angular_stiffness_nm_per_rad = angular,
                                          .parallel_misalignment_m = 1e-4,
                                          .parallel_misalignment_angle_deg = 70,
                                          .lateral_asymmetry_ratio = ratio,
                                          .stiff_axis_phase_deg = axis_deg});
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const Eigen::Index w = shaft.deflection(0.2);
  Eigen::VectorXcd at_rest = Eigen::VectorXcd::Zero(shaft.coordinates());
  at_rest(w) = Complex(1e-5, -2e-5);
  at_rest(w + 2) = Complex(-3e-5, 1e-5);
  const Complex stretched = at_rest(w + 2) - at_rest(w) + std::polar(1e-4, 70 * std::numbers::pi / 180);
  const Eigen::VectorXcd load = twice_per_turn_load(shaft, kit, at_rest);
  for (const double turned : {0.0, 0.4, 2.0, 5.1}) {
    const double axis = turned + axis_deg * std::numbers::pi / 180;
    const Complex along = stretched * std::polar(1.0, -axis);
    const Complex pulled(lateral * (1 + ratio) * along.real(), lateral * (1 - ratio) * along.imag());
    const Complex beyond = -pulled * std::polar(1.0, axis) + lateral * stretched;
    const Complex push = load(w + 2) * std::polar(1.0, 2 * turned);
    EXPECT_NEAR(std::abs(push - beyond), 0, 1e-10 * std::abs(lateral * stretched)) << turned;
    EXPECT_EQ(load(w), -load(w + 2));
  }
  EXPECT_EQ(load(w + 1), Complex(0));
}

TEST(CouplingLoads, TheAngularPartGoesByTheLeanAlone) {
  const model::RotorKit kit = two_shafts({.position_m = 0.2,
                                          .lateral_stiffness_n_per_m = lateral,
                                          .angular_stiffness_nm_per_rad = angular,
                                          .angular_misalignment_rad = 1e-3,
                                          .angular_asymmetry_ratio = 0.2});
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const Eigen::Index w = shaft.deflection(0.2);
  const Eigen::VectorXcd load = twice_per_turn_load(shaft, kit, Eigen::VectorXcd::Zero(shaft.coordinates()));
  EXPECT_NEAR(std::abs(load(w + 3) - Complex(-0.2 * angular * 1e-3)), 0, 1e-12);
  EXPECT_EQ(load(w + 2), Complex(0));
}

/// Unequal supports with cross stiffness: the rest position satisfies the equations of both planes.
TEST(CouplingLoads, ThePositionAtRestBalancesTheLoad) {
  model::RotorKit kit = two_shafts(
      {.position_m = 0.2, .lateral_stiffness_n_per_m = lateral, .angular_stiffness_nm_per_rad = angular});
  kit.supports[1].stiffness_y_n_per_m = 3e6;
  kit.supports[1].stiffness_xy_n_per_m = 2e5;
  kit.supports[1].stiffness_yx_n_per_m = -3e5;
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const Eigen::VectorXcd load = Eigen::VectorXcd::Random(shaft.coordinates());
  const Eigen::VectorXcd q = position_at_rest(shaft, load);
  const Eigen::VectorXd x = q.real(), y = q.imag();
  const Eigen::VectorXd in_x = shaft.plane_stiffness(0) * x + shaft.support_stiffness[0][1] * y,
                        in_y = shaft.plane_stiffness(1) * y + shaft.support_stiffness[1][0] * x;
  EXPECT_LT((in_x - load.real()).norm(), 1e-6 * load.norm());
  EXPECT_LT((in_y - load.imag()).norm(), 1e-6 * load.norm());
}

}  // namespace
}  // namespace rubsweep::structure
