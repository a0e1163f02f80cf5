#include "rubsweep/maps/config/machine/matrix_rotor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/structure/whirl_eigenvalues.hpp"
#include "maps/config/machine/book_examples.hpp"
#include "maps/config/machine/matrix_text.hpp"
#include "maps/config/machine/ross_text.hpp"
#include "rubsweep/core/structure/matrix_shaft.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

using std::numbers::pi;

void expect_within(const model::RotorKit& a, const model::RotorKit& b, double tolerance) {
  const structure::LateralSystem left = structure::full(a), right = structure::full(b);
  const auto relative = [](const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
    return (x - y).norm() / x.norm();
  };
  EXPECT_LE(relative(left.mass, right.mass), tolerance);
  EXPECT_LE(relative(left.stiffness, right.stiffness), tolerance);
  EXPECT_LE(relative(left.gyroscopic, right.gyroscopic), tolerance);
}

/// Largest difference of the whirl eigenvalues, relative to their moduli.
double whirl_difference(const model::RotorKit& a, const model::RotorKit& b, double speed_rad_per_s) {
  const auto left = structure::whirl_eigenvalues(structure::full(a), speed_rad_per_s),
             right = structure::whirl_eigenvalues(structure::full(b), speed_rad_per_s);
  double largest = left.size() == right.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i)
    largest = std::max(largest, std::abs(left[i] - right[i]) / std::abs(left[i]));
  return largest;
}

void expect_printed(const model::RotorKit& kit, double speed_rad_per_s, const std::vector<double>& printed,
                    double within) {
  const auto found = structure::whirl_eigenvalues(structure::full(kit), speed_rad_per_s);
  for (std::size_t i = 0; i < printed.size(); ++i)
    EXPECT_NEAR(found.at(i).imag(), printed[i], within * printed[i]) << i;
}

model::RotorKit exported_and_read(const model::RotorKit& kit) {
  model::Machine machine;
  machine.rotor = kit;
  const MatrixFiles files;
  files.write(*model::kit_of(structure::machine_by_matrices(machine))->matrices);
  return *model::kit_of(files.read().study.machine);
}

/// The same rotor in four forms: typed, from a file of ROSS, as matrices assembled from the book's formulas,
/// and as the exported matrices of the typed rotor.
TEST(MatrixRotor, ComesThroughEveryDoorAsTheSameRotor) {
  const RossFiles ross;
  for (const BookExample& example : book_examples()) {
    SCOPED_TRACE(example.number);
    const model::RotorKit as_typed = typed(example);
    const model::RotorKit by_ross = ross.kit(as_ross_file(example));
    const MatrixFiles files;
    files.write(as_matrices(example));
    const model::RotorKit by_hand = *model::kit_of(files.read().study.machine);
    expect_within(as_typed, by_ross, 1e-12);
    expect_within(as_typed, by_hand, 1e-12);
    expect_within(as_typed, exported_and_read(as_typed), 0);
    for (const double speed_rad_per_s : {0.0, 4000 * pi / 30}) {
      EXPECT_LT(whirl_difference(as_typed, by_ross, speed_rad_per_s), 1e-12) << speed_rad_per_s;
      EXPECT_LT(whirl_difference(as_typed, by_hand, speed_rad_per_s), 1e-12) << speed_rad_per_s;
    }
    expect_printed(by_hand, 0, example.at_rest_rad_per_s, example.printed_within);
    expect_printed(by_ross, 4000 * pi / 30, example.turning_rad_per_s, example.printed_within);
  }
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
  EXPECT_NE(files.message({"rotor.mass_damping_per_s=2"}).find("is part of what the damping matrix says"),
            std::string::npos);
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
