#include "rubsweep/core/structure/matrix_shaft.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <limits>

#include "core/structure/hand_matrices.hpp"
#include "core/structure/steel.hpp"
#include "maps/batch/message_of.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::structure {
namespace {

TEST(MatrixShaftLayout, HasASlopeThatTheMatricesLeaveOut) {
  const model::ShaftMatrices matrices = disc_and_bracket();
  const MatrixLayout layout = layout_of(matrices);
  EXPECT_EQ(layout.coordinates(), 3);
  EXPECT_FALSE(layout.plane[0][1].freedom);
  EXPECT_EQ(layout.plane[1][2].freedom, Eigen::Index{3});
  EXPECT_EQ(layout.bodies, (std::vector<Eigen::Index>{2}));
  Eigen::Matrix3d cross;
  cross << 3e3, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(block(matrices.stiffness, layout, 0, 1), cross);
}

TEST(MatrixShaftLayout, CountsAnglesAboutXTheOtherWay) {
  model::ShaftMatrices matrices = empty_matrices(freedoms_at({0.3}));
  matrices.stiffness(1, 2) = 7;
  const MatrixLayout layout = layout_of(matrices);
  EXPECT_EQ(block(matrices.stiffness, layout, 1, 1), (Eigen::Matrix2d{{0, -7}, {0, 0}}));
}

TEST(MatrixShaftLayout, NamesTheUnbalanceThatDoesNotTurn) {
  model::ShaftMatrices matrices = disc_and_bracket();
  EXPECT_FALSE(turning_unbalance(matrices, layout_of(matrices)).wrong);
  matrices.unbalance_kg(1) = std::complex<double>(0, 2);
  EXPECT_EQ(turning_unbalance(matrices, layout_of(matrices)).wrong, std::size_t{1});
}

TEST(MatrixShaft, PartsThePlanesOfADiscAndABracket) {
  const BeamShaft shaft = matrix_shaft(disc_and_bracket());
  ASSERT_EQ(shaft.coordinates(), 3) << "the disc's deflection, a slope that nothing bends, the bracket";
  EXPECT_EQ(shaft.node_position_m, (std::vector<double>{0.5}));
  EXPECT_EQ(shaft.deflection(0.5), 0);
  EXPECT_EQ(shaft.housings, (std::vector<Eigen::Index>{2}));
  Eigen::Matrix3d x, y, cross_x, cross_y;
  x << 1e5, 0, -2e4, 0, 1, 0, -2e4, 0, 5e4;
  y << 2e5, 0, -2e4, 0, 1, 0, -2e4, 0, 6e4;
  cross_x << 3e3, 0, 0, 0, 0, 0, 0, 0, 0;
  cross_y << -4e3, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_EQ(shaft.plane_stiffness(0), x);
  EXPECT_EQ(shaft.plane_stiffness(1), y);
  EXPECT_EQ(shaft.support_stiffness[0][1], cross_x);
  EXPECT_EQ(shaft.support_stiffness[1][0], cross_y);
  EXPECT_EQ(shaft.plane_mass(0), Eigen::Matrix3d(Eigen::Vector3d(2, 0, 5).asDiagonal()));
  EXPECT_EQ(shaft.support_damping[1][1], Eigen::Matrix3d(Eigen::Vector3d(20, 0, 40).asDiagonal()));
  EXPECT_EQ(shaft.weight_kg, Eigen::Vector3d(2, 0, 5));
  EXPECT_EQ(shaft.unbalance_kg, Eigen::Vector3cd(2, 0, 0));
}

TEST(MatrixShaft, TurnsAnglesAboutXIntoSlopes) {
  model::ShaftMatrices matrices = empty_matrices(freedoms_at({0.3}));
  matrices.mass.diagonal() << 3, 3, 0.1, 0.1;
  matrices.stiffness.diagonal() << 1e6, 1e6, 1e3, 1e3;
  // A disc at the end of a cantilever with E I = l = 1 and K_ws = -6, multiplied by 1e2. In y the slope is
  // -rx.
  matrices.stiffness(0, 3) = matrices.stiffness(3, 0) = -6e2;
  matrices.stiffness(1, 2) = matrices.stiffness(2, 1) = 6e2;
  matrices.gyroscopic(2, 3) = 0.2, matrices.gyroscopic(3, 2) = -0.2;
  matrices.degrees_of_freedom[2].weight_kg = 0.25;
  const std::complex<double> i(0, 1);
  matrices.unbalance_kg << 0.1, -i * 0.1, i * 0.02, 0.02;
  const BeamShaft shaft = matrix_shaft(matrices);
  EXPECT_EQ(shaft.plane_stiffness(0), shaft.plane_stiffness(1));
  EXPECT_EQ(shaft.plane_stiffness(1)(0, 1), -6e2);
  EXPECT_EQ(shaft.gyroscopic, (Eigen::Matrix2d{{0, 0}, {0, 0.2}}));
  EXPECT_EQ(shaft.unbalance_kg, Eigen::Vector2cd(0.1, 0.02));
  EXPECT_EQ(shaft.weight_kg, Eigen::Vector2d(3, -0.25));
}

TEST(MatrixShaft, SortsNodesByTheirPlaceAndKeepsTheOrderOfTwoAtOne) {
  model::ShaftMatrices matrices = empty_matrices(freedoms_at({1, 0, 0.5, 0.5}));
  for (Eigen::Index i = 0; i < 16; ++i)
    matrices.mass(i, i) = matrices.stiffness(i, i) = static_cast<double>(1 + i / 4);
  const BeamShaft shaft = matrix_shaft(matrices);
  EXPECT_EQ(shaft.node_position_m, (std::vector<double>{0, 0.5, 0.5, 1}));
  const Eigen::VectorXd found = shaft.plane_stiffness(1).diagonal();
  EXPECT_EQ(found, (Eigen::VectorXd(8) << 2, 2, 3, 3, 4, 4, 1, 1).finished());
}

TEST(MatrixShaft, TakesTheUnbalanceOfOnePlaneForBoth) {
  model::ShaftMatrices matrices = disc_and_bracket();
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  matrices.unbalance_kg(0) = {unknown, unknown};
  EXPECT_EQ(matrix_shaft(matrices).unbalance_kg, Eigen::Vector3cd(2, 0, 0));
  matrices.unbalance_kg(0) = 2, matrices.unbalance_kg(1) = {unknown, unknown};
  EXPECT_EQ(matrix_shaft(matrices).unbalance_kg, Eigen::Vector3cd(2, 0, 0));
  matrices.unbalance = {{"disc", 3, 0.5, 90}};
  const std::complex<double> sum = matrix_shaft(matrices).unbalance_kg(0);
  EXPECT_NEAR(std::abs(sum - std::complex<double>(2, 1.5)), 0, 1e-15);
}

TEST(MatrixShaft, IsSymmetricWhereRoundingLeftTheMatrixUneven) {
  model::ShaftMatrices matrices = disc_and_bracket();
  matrices.stiffness(0, 2) *= 1 + 1e-12;
  const BeamShaft shaft = matrix_shaft(matrices);
  EXPECT_EQ(shaft.plane_stiffness(0)(0, 2), shaft.plane_stiffness(0)(2, 0));
}

TEST(MatrixShaft, ThrowsTheFirstProblemToUsersOfTheLibrary) {
  model::ShaftMatrices matrices = disc_and_bracket();
  matrices.mass.setZero();
  EXPECT_EQ(message_of<ConfigError>([&] { matrix_shaft(matrices); }),
            "rotor.mass: is zero, allowed: a positive definite matrix");
}

/// Kit with everything that matrices can express: unequal, cross-coupled and damped bearings, one with fluid,
/// a pedestal, a housing, an aligned coupling, skewed and unbalanced discs, point masses, material damping, a
/// static load and a sensor.
model::Machine rich_machine() {
  model::RotorKit kit;
  kit.shaft = {steel_segment(0.5, 0.03), steel_segment(0.3, 0.025)};
  kit.shaft[0].mass_damping_per_s = 0.3;
  kit.shaft[0].stiffness_damping_s = 1e-6;
  kit.discs = {
      {.position_m = 0.2, .mass_kg = 4, .polar_inertia_kg_m2 = 0.02, .diametral_inertia_kg_m2 = 0.011},
      {.position_m = 0.7,
       .mass_kg = 2,
       .polar_inertia_kg_m2 = 0.01,
       .diametral_inertia_kg_m2 = 0.006,
       .eccentricity_ratio = 0.5,
       .eccentricity_phase_deg = 70,
       .skew_rad_per_m = 3,
       .skew_phase_deg = 20}};
  kit.point_masses = {{.position_m = 0.45, .mass_kg = 0.3, .mass_y_kg = 0.4}};
  kit.housings = {{.mass_kg = 6, .mass_y_kg = 7}};
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(0.8, 2e6), isotropic_support(0, 3e6)};
  kit.supports[0].stiffness_y_n_per_m = 1.2e6;
  kit.supports[0].stiffness_xy_n_per_m = 1e5, kit.supports[0].stiffness_yx_n_per_m = -2e5;
  kit.supports[0].damping_x_ns_per_m = 150, kit.supports[0].damping_xy_ns_per_m = 20;
  kit.supports[0].mass_x_kg = 0.2, kit.supports[0].mass_y_kg = 0.25;
  kit.supports[0].on_housing = 0;
  kit.supports[1].pedestal =
      model::Pedestal{.mass_kg = 3, .stiffness_x_n_per_m = 8e6, .stiffness_y_n_per_m = 9e6};
  kit.supports[1].angular_stiffness_nm_per_rad = 500;
  kit.supports[2].at_housing = 0;
  kit.couplings = {
      {.position_m = 0.5, .lateral_stiffness_n_per_m = 1e8, .angular_stiffness_nm_per_rad = 1e5}};
  kit.static_loads = {{.position_m = 0.6, .force_x_n = 3, .force_y_n = -20}};
  kit.sensors = {{.position_m = 0.35, .angle_deg = 45}};
  kit.damping_ratio = {0.01, 0.02};
  model::Machine machine;
  machine.rotor = kit;
  model::Stop& stop = machine.stops.emplace_back();
  stop.geometry = model::AnnularGeometry{};
  stop.position_m = 0.65;
  stop.clearance_m = 1e-3, stop.stiffness_n_per_m = 1e7, stop.contact_radius_m = 0.02;
  stop.damping = model::NominalRestitution{0.7};
  stop.friction = model::ConstantFriction{0.1};
  machine.gravity_m_per_s2 = 9.81;
  return machine;
}

model::RotorKit& kit_in(model::Machine& machine) { return *model::kit_of(machine); }

void expect_same(const Assembly& a, const Assembly& b) {
  EXPECT_EQ(a.system.mass, b.system.mass);
  EXPECT_EQ(a.system.damping, b.system.damping);
  EXPECT_EQ(a.system.stiffness, b.system.stiffness);
  EXPECT_EQ(a.gyroscopic, b.gyroscopic);
  EXPECT_EQ(a.system.unbalance_kg, b.system.unbalance_kg);
  EXPECT_EQ(a.system.weight_kg, b.system.weight_kg);
  EXPECT_EQ(a.static_n, b.static_n);
  EXPECT_EQ(a.contact_mass_kg, b.contact_mass_kg);
  ASSERT_EQ(a.system.points.size(), b.system.points.size());
  for (std::size_t i = 0; i < a.system.points.size(); ++i)
    EXPECT_EQ(a.system.points[i].map, b.system.points[i].map);
}

TEST(MatrixShaftExport, IsReducedToTheSameBits) {
  const model::Machine machine = rich_machine();
  const model::Machine exported = machine_by_matrices(machine);
  ASSERT_TRUE(model::kit_of(exported)->matrices);
  EXPECT_TRUE(model::kit_of(exported)->supports.empty());
  const KitAssembly typed = assemble_rotor_kit(machine), read = assemble_rotor_kit(exported);
  expect_same(typed.assembly, read.assembly);
  EXPECT_EQ(typed.reduction.receptance_error, read.reduction.receptance_error);
  EXPECT_FALSE(typed.assembly.system.stiffness.isApprox(typed.assembly.system.stiffness.transpose()));
}

TEST(MatrixShaftExport, KeepsSupportsThatFollowATable) {
  model::Machine machine = rich_machine();
  model::SupportTable table{.speed_hz = {10, 20, 30, 40}, .columns = {}};
  for (auto& column : table.columns) column = {0, 0, 0, 0};
  table.columns[0] = table.columns[3] = {1e6, 1.1e6, 1.3e6, 1.4e6};
  kit_in(machine).supports[1] = model::with_table(kit_in(machine).supports[1], table);
  const model::Machine exported = machine_by_matrices(machine);
  ASSERT_EQ(model::kit_of(exported)->supports.size(), 1U);
  const Assembly typed = assemble_rotor_kit(machine).assembly, read = assemble_rotor_kit(exported).assembly;
  ASSERT_EQ(read.tables.size(), 1U);
  const auto relative = [](const auto& x, const auto& y) { return (x - y).norm() / x.norm(); };
  // The matrices contain the sum of all other parts; further terms are added, and rounded, in another order.
  EXPECT_LT(relative(typed.system.stiffness, read.system.stiffness), 1e-9);
  EXPECT_LT(relative(typed.system.mass, read.system.mass), 1e-9);
  EXPECT_LT(relative(typed.tables[0].map, read.tables[0].map), 1e-9);
  kit_in(machine).supports[0] = model::with_table(kit_in(machine).supports[0], table);
  EXPECT_EQ(message_of<ConfigError>([&] { machine_by_matrices(machine); }),
            "rotor.supports.0: follows a table or strikes the shaft beside a housing and cannot be said by "
            "matrices, allowed: such a support of the shaft on the ground or a pedestal");
}

TEST(MatrixShaftExport, HasTheMatricesOfTheBook) {
  model::RotorKit kit;
  kit.shaft = {steel_segment(1.5, 0.05)};
  kit.discs = {{0.5, 32.58972765304033, 0.32956362089137037, 0.17808928257067666},
               {1, 51.52526111152619, 0.8050822048675967, 0.42358058405433824}};
  kit.supports = {isotropic_support(0, 1e6), isotropic_support(1.5, 1e6)};
  kit.elements = 6;
  model::Machine machine;
  machine.rotor = kit;
  const model::ShaftMatrices found = *model::kit_of(machine_by_matrices(machine))->matrices,
                             book = book_rotor();
  ASSERT_EQ(found.mass.rows(), book.mass.rows());
  EXPECT_LT((found.mass - book.mass).norm(), 1e-13 * book.mass.norm());
  EXPECT_LT((found.stiffness - book.stiffness).norm(), 1e-13 * book.stiffness.norm());
  EXPECT_LT((found.gyroscopic - book.gyroscopic).norm(), 1e-13 * book.gyroscopic.norm());
  EXPECT_LT((found.unbalance_kg - book.unbalance_kg).norm(), 1e-13 * book.unbalance_kg.norm());
  for (std::size_t i = 0; i < 28; ++i) {
    EXPECT_EQ(found.degrees_of_freedom[i].node, book.degrees_of_freedom[i].node);
    EXPECT_EQ(found.degrees_of_freedom[i].direction, book.degrees_of_freedom[i].direction);
    EXPECT_NEAR(*found.degrees_of_freedom[i].position_m, *book.degrees_of_freedom[i].position_m, 1e-15);
  }
}

TEST(MatrixShaftExport, RefusesWhatMatricesCannotSay) {
  const auto refused = [](auto change) {
    model::Machine machine = rich_machine();
    change(kit_in(machine));
    return message_of<ConfigError>([&] { machine_by_matrices(machine); });
  };
  EXPECT_EQ(refused([](auto& kit) {
              kit.bow = model::Bow{model::BowMode{1, 1e-4}, 0};
            }),
            "rotor.bow: is a line of the shaft without load and cannot be said by matrices, allowed: no bow");
  EXPECT_EQ(refused([](auto& kit) {
              kit.torsion = model::Torsion{1e3, 1};
            }),
            "rotor.torsion: is no lateral motion and cannot be said by matrices, allowed: no torsion");
  EXPECT_EQ(
      refused([](auto& kit) { kit.couplings[0].parallel_offset_m = 1e-4; }),
      "rotor.couplings: join ends out of line and cannot be said by matrices, allowed: couplings in line");
  EXPECT_EQ(refused([](auto& kit) { kit.couplings[0].angular_misalignment_rad = 1e-4; }),
            "rotor.couplings: join machines out of line and cannot be said by matrices, allowed: machines in "
            "line");
  EXPECT_EQ(
      refused([](auto& kit) { kit.couplings[0].lateral_asymmetry_ratio = 0.1; }),
      "rotor.couplings: have an asymmetry ratio and cannot be said by matrices, allowed: couplings that "
      "are equally stiff all around");
  model::Machine jeffcott;
  jeffcott.rotor = model::JeffcottRotor{1, 30, 0.01};
  EXPECT_EQ(message_of<ConfigError>([&] { machine_by_matrices(jeffcott); }),
            "rotor.kind: a Jeffcott rotor has no finite elements, allowed: a rotor kit");
}

TEST(MatrixShaftExport, LeavesMatricesAsTheyAre) {
  const model::Machine exported = machine_by_matrices(rich_machine());
  EXPECT_EQ(model::kit_of(machine_by_matrices(exported))->matrices, model::kit_of(exported)->matrices);
}

TEST(MatrixShaftExport, OfAStopBetweenNodesIsRefusedByTheAssembly) {
  model::Machine exported = machine_by_matrices(rich_machine());
  exported.stops[0].position_m = 0.653;
  EXPECT_EQ(message_of<ConfigError>([&] { assemble_rotor_kit(exported); }),
            "rotor.degrees_of_freedom: has no node at 0.653000 m, where a stop, kick, sensor, load or "
            "support stands, "
            "allowed: such places at nodes");
}

}  // namespace

}  // namespace rubsweep::structure
