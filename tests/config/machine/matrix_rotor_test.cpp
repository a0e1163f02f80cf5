#include "rubsweep/config/machine/matrix_rotor.hpp"

#include <gtest/gtest.h>

#include "config/machine/matrix_text.hpp"
#include "config/machine/ross_text.hpp"
#include "rubsweep/config/exported_matrices.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/structure/beam_shaft.hpp"
#include "rubsweep/structure/lateral_system.hpp"
#include "rubsweep/structure/matrix_export.hpp"
#include "structure/hand_matrices.hpp"
#include "structure/steel.hpp"

namespace rubsweep::config::machine {
namespace {

structure::LateralSystem full(const model::RotorKit& kit) {
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, {});
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(shaft.coordinates(), shaft.coordinates());
  return structure::project(shaft, {identity, identity});
}

Eigen::VectorXd frequencies(const model::RotorKit& kit) {
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, {});
  return structure::plane_modes(shaft.plane_mass(1), shaft.plane_stiffness(1), 6).rad_per_s;
}

void expect_within(const model::RotorKit& a, const model::RotorKit& b, double tolerance) {
  const structure::LateralSystem left = full(a), right = full(b);
  const auto relative = [](const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
    return (x - y).norm() / x.norm();
  };
  EXPECT_LE(relative(left.mass, right.mass), tolerance);
  EXPECT_LE(relative(left.stiffness, right.stiffness), tolerance);
  EXPECT_LE(relative(left.gyroscopic, right.gyroscopic), tolerance);
  EXPECT_LE((frequencies(a) - frequencies(b)).cwiseQuotient(frequencies(a)).cwiseAbs().maxCoeff(), tolerance);
}

/// Example 5.9.1 of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010), typed, from a file
/// of ROSS, as matrices by hand from the book's formulas, and as the matrices that the typed one is exported
/// as.
TEST(MatrixRotor, ComesThroughEveryDoorAsTheSameRotor) {
  model::RotorKit typed;
  typed.shaft = {structure::steel_segment(1.5, 0.05)};
  typed.discs = {{0.5, 32.58972765304033, 0.32956362089137037, 0.17808928257067666},
                 {1, 51.52526111152619, 0.8050822048675967, 0.42358058405433824}};
  typed.supports = {structure::isotropic_support(0, 1e6), structure::isotropic_support(1.5, 1e6)};
  typed.elements = 6;
  const RossFiles ross;
  const model::RotorKit by_ross = ross.kit(
      ross_shafts(6, 0.25) + ross_disc(0, 2, 32.58972765304033, 0.32956362089137037, 0.17808928257067666) +
      ross_disc(1, 4, 51.52526111152619, 0.8050822048675967, 0.42358058405433824) +
      ross_bearing(0, 0, "kxx = 1e6") + ross_bearing(1, 6, "kxx = 1e6"));
  const MatrixFiles files;
  files.write(structure::book_rotor());
  const model::RotorKit by_hand = *model::kit_of(files.read().study.machine);
  model::Machine machine;
  machine.rotor = typed;
  const MatrixFiles exported;
  exported.write(*model::kit_of(structure::machine_by_matrices(machine))->matrices);
  const model::RotorKit by_export = *model::kit_of(exported.read().study.machine);
  expect_within(typed, by_ross, 1e-12);
  expect_within(typed, by_hand, 1e-12);
  expect_within(typed, by_export, 0);
  // ROSS prints these of its docs/examples/example_05_09_01.rst at rest.
  const double printed[]{86.65811435, 274.31285391, 716.78631221};
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_NEAR(frequencies(by_hand)(i), printed[i], 2e-7 * printed[i]);
}

TEST(MatrixRotor, TakesSupportsBesideItsMatrices) {
  const MatrixFiles files;
  model::ShaftMatrices loose = structure::book_rotor();
  for (const Eigen::Index i : {0, 1, 24, 25}) loose.stiffness(i, i) -= 1e6;
  files.write(loose);
  const std::string free =
      "stiffness.mtx:1:1: rotor.stiffness: is not positive definite: the rotor is free to move in ";
  const std::string held = ", allowed: the stiffness of a rotor that is held, or supports that hold it";
  EXPECT_EQ(files.message(), free + "x" + held + "\n" + free + "y" + held);
  const std::string supports =
      "rotor.supports=[{position_m: 0, stiffness_x_n_per_m: 1e6, stiffness_y_n_per_m: 1e6}, {position_m: "
      "1.5, "
      "stiffness_x_n_per_m: 1e6, stiffness_y_n_per_m: 1e6}]";
  const model::RotorKit found = *model::kit_of(files.read({supports}).study.machine);
  MatrixFiles whole;
  whole.write(structure::book_rotor());
  expect_within(*model::kit_of(whole.read().study.machine), found, 1e-9);
  EXPECT_EQ(files.message({supports, "rotor.supports.1.position_m=1.4"}),
            "--set rotor.supports.1.position_m=1.4: rotor.supports.1.position_m: at 1.4 m stands no node, "
            "allowed: a "
            "position_m of degrees_of_freedom, of which 1.5 is the nearest");
}

TEST(MatrixRotor, HasStopsSensorsAndLoadsAtNodesAlone) {
  const MatrixFiles files;
  files.write(structure::book_rotor());
  const std::string rest =
      " m stands no node, allowed: a position_m of degrees_of_freedom, of which 0.5 is the nearest";
  EXPECT_EQ(files.message({"stops.0.position_m=0.51"}),
            "--set stops.0.position_m=0.51: stops.0.position_m: at 0.51" + rest);
  EXPECT_EQ(
      files.message({"rotor.sensors=[{position_m: 0.5}, {position_m: 0.49}]"}),
      "--set rotor.sensors=[{position_m: 0.5}, {position_m: 0.49}]: rotor.sensors.1.position_m: at 0.49" +
          rest);
  EXPECT_EQ(files.message({"rotor.static_loads=[{position_m: 0.45, force_y_n: 1}]"}),
            "--set rotor.static_loads=[{position_m: 0.45, force_y_n: 1}]: rotor.static_loads.0.position_m: "
            "at 0.45" +
                rest);
  EXPECT_EQ(files.message({"kick={force_n: 1, duration_s: 0.001, position_m: 0.4}"}),
            "--set kick={force_n: 1, duration_s: 0.001, position_m: 0.4}: kick.position_m: at 0.4" + rest);
}

TEST(MatrixRotor, RefusesPartsThatNeedTheShaftItself) {
  const MatrixFiles files;
  files.write(structure::book_rotor());
  EXPECT_EQ(files.message({"rotor.bow={mode: 1, amplitude_m: 1e-4}"}),
            "--set rotor.bow={mode: 1, amplitude_m: 1e-4}: rotor.bow: needs the shaft's own stiffness, which "
            "matrices do "
            "not part from that of its supports, allowed: a rotor of kind: rotor_kit");
  EXPECT_NE(
      files.message({"rotor.torsion={drive_stiffness_nm_per_rad: 1e3}"}).find("needs the polar inertia"),
      std::string::npos);
  EXPECT_NE(files.message({"rotor.elements=10"}).find("rotor.elements: are those of the program"),
            std::string::npos);
  EXPECT_NE(files.message({"rotor.mas=1"}).find("rotor.mas: unknown key (did you mean 'mass'?)"),
            std::string::npos);
}

TEST(MatrixRotor, RefusesDampingThatTurnsBesideBodiesThatDoNot) {
  const MatrixFiles files;
  files.write(structure::disc_and_bracket());
  EXPECT_EQ(files.message({"rotor.rotating_damping_ratio=0.01"}),
            "--set rotor.rotating_damping_ratio=0.01: rotor.rotating_damping_ratio: turns with the shaft, "
            "and bodies "
            "beside it do not, allowed: 0 beside degrees of freedom without position_m");
}

}  // namespace
}  // namespace rubsweep::config::machine
