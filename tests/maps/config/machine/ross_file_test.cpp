#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/structure/whirl_eigenvalues.hpp"
#include "maps/config/machine/ross_text.hpp"
#include "rubsweep/core/structure/beam_element.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/maps/config/machine/rotor.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

using std::numbers::pi;

double difference(const model::RotorKit& a, const model::RotorKit& b) {
  const structure::LateralSystem left = structure::full(a), right = structure::full(b);
  const auto relative = [](const Eigen::MatrixXd& x, const Eigen::MatrixXd& y) {
    return (x - y).norm() / std::max(x.norm(), 1e-300);
  };
  return std::max({relative(left.mass, right.mass), relative(left.damping, right.damping),
                   relative(left.gyroscopic, right.gyroscopic), relative(left.stiffness, right.stiffness)});
}

/// The rotor of ross/agent_skills/ross/my_rotor.toml in ROSS 2.3.0 (github.com/petrobras/ross, Apache 2.0),
/// with its natural frequencies according to ROSS at 200 rad/s.
TEST(RossFile, HasTheFrequenciesThatRossGives) {
  const RossFiles files;
  const model::RotorKit kit = files.kit(
      ross_shafts(6, 0.05) + ross_disc(0, 2, 32.58972765304033, 0.32956362089137037, 0.17808928257067666) +
      ross_disc(1, 4, 32.59, 0.329, 0.178) + ross_bearing(0, 0, "kxx = [1000000.0,]\nkyy = [1000000.0,]") +
      ross_bearing(1, 6, "kxx = [1000000.0,]\nkyy = [800000.0,]\ncxx = [ 100,]\ncyy = [ 80,]"));
  constexpr double printed[][2] = {{156.631313369495, 156.634212731449}, {168.216249859535, 168.217699450096},
                                   {184.373503552928, 184.374960659532}, {420.70925910699, 420.716647526978},
                                   {2491.23101694422, 2491.23127548789}, {2850.33787972171, 2850.33817999579},
                                   {6571.65564509833, 6571.65564510396}, {6694.12290558583, 6694.12290558584},
                                   {20930.0413369614, 20930.2639284908}, {20932.7676594552, 20932.7676594556},
                                   {20954.3012452393, 20954.5711812063}, {20962.5392659309, 20962.539265933}};
  const auto found = structure::whirl_eigenvalues(structure::full(kit), 200);
  for (std::size_t i = 0; i < std::size(printed); ++i) {
    const auto [wd, wn] = std::pair(printed[i][0], printed[i][1]);
    EXPECT_NEAR(found[i].imag(), wd, 1e-9 * wn) << i;
    EXPECT_NEAR(std::abs(found[i]), wn, 1e-9 * wn) << i;
  }
}

model::Support isotropic(double position_m, double stiffness, double damping) {
  model::Support support;
  support.position_m = position_m;
  support.stiffness_x_n_per_m = support.stiffness_y_n_per_m = stiffness;
  support.damping_x_ns_per_m = support.damping_y_ns_per_m = damping;
  return support;
}

model::ShaftSegment steel(double length_m) {
  return {{.outer_diameter_m = 0.05,
           .youngs_modulus_pa = 211e9,
           .shear_modulus_pa = 81.2e9,
           .density_kg_per_m3 = 7810},
          length_m};
}

model::RotorKit small_kit() {
  model::RotorKit kit;
  kit.shaft = {steel(0.2), steel(0.2), steel(0.2)};
  kit.discs = {
      {.position_m = 0.2, .mass_kg = 10, .polar_inertia_kg_m2 = 0.1, .diametral_inertia_kg_m2 = 0.06}};
  kit.supports = {isotropic(0, 1e6, 100), isotropic(0.6, 2e6, 50)};
  kit.elements = 1;
  return kit;
}

/// Example 5.9.1 of Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines (2010), in six elements.
TEST(RossFile, IsTheTypedRotor) {
  const RossFiles files;
  EXPECT_LT(difference(files.kit(small_ross()), small_kit()), 1e-14);
  model::RotorKit typed;
  typed.shaft = {steel(1.5)};
  typed.discs = {{.position_m = 0.5,
                  .mass_kg = 32.58972765304033,
                  .polar_inertia_kg_m2 = 0.32956362089137037,
                  .diametral_inertia_kg_m2 = 0.17808928257067666},
                 {.position_m = 1,
                  .mass_kg = 51.67927765304033,
                  .polar_inertia_kg_m2 = 0.8056,
                  .diametral_inertia_kg_m2 = 0.4239}};
  typed.supports = {isotropic(0, 1e6, 0), isotropic(1.5, 1e6, 0)};
  typed.elements = 6;
  const model::RotorKit read = files.kit(
      ross_shafts(6, 0.25) + ross_disc(0, 2, 32.58972765304033, 0.32956362089137037, 0.17808928257067666) +
      ross_disc(1, 4, 51.67927765304033, 0.8056, 0.4239) + ross_bearing(0, 0, "kxx = 1e6") +
      ross_bearing(1, 6, "kxx = 1000000"));
  EXPECT_LT(difference(read, typed), 1e-12);
  for (const double speed : {0.0, 4000 * pi / 30}) {
    const auto a = structure::whirl_eigenvalues(structure::full(read), speed),
               b = structure::whirl_eigenvalues(structure::full(typed), speed);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(a[i].imag(), b[i].imag(), 1e-11 * b[i].imag()) << i;
  }
}

TEST(RossFile, InJsonIsTheSameRotor) {
  const RossFiles files;
  const std::string shaft =
      R"("ShaftElement_a b_{0}": {{"L": 0.2, "idl": 0, "odl": 0.05, "material": {{"name": "s", "rho": 7810, "E": 2.11e11,
      "G_s": 8.12e10, "color": "#525252"}}, "n": {0}, "axial_force": 0, "tag": null}},)";
  std::string text =
      "{\"_note\": \"by hand\", \"ross_version\": \"2.0.0\", \"parameters\": {\"min_w\": null},";
  for (int n = 0; n < 3; ++n) text += fmt::format(fmt::runtime(shaft), n);
  text += R"("DiskElement_Disk 0": {"n": 1, "m": 10, "Id": 0.06, "Ip": 0.1},
    "BearingElement_0": {"n": 0, "kxx": [1e6], "cxx": 100, "kyy": null, "n_link": null},
    "SealElement_x": {"n": 3, "kxx": 2e6, "cxx": [50], "seal_leakage": null}})";
  EXPECT_EQ(difference(files.kit(text, "rotor.json"), files.kit(small_ross())), 0);
}

TEST(RossFile, IsPrintedAsARotorKit) {
  const RossFiles files;
  const RunConfig config = files.read(small_ross());
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("kind: rotor_kit"), std::string::npos);
  const RunConfig again = read_run_config_text(printed, "printed.yaml", {});
  EXPECT_EQ(print_config(again), printed);
  EXPECT_EQ(difference(*model::kit_of(again.study.machine), *model::kit_of(config.study.machine)), 0);
}

TEST(RossFile, LayersOfOneNodeAreAddedTheStiffestFirst) {
  const RossFiles files;
  std::string sleeve = ross_shaft(9, 1, 0.2, 0.08);
  sleeve = replaced(replaced(sleeve, "idl = 0.0", "idl = 0.05"), "idr = 0.0", "idr = 0.05");
  sleeve =
      replaced(replaced(sleeve, "E = 211000000000.0", "E = 6894.75"), "G_s = 81200000000.0", "G_s = 6894.75");
  model::RotorKit typed = small_kit();
  typed.shaft[1].layers.push_back({.outer_diameter_m = 0.08,
                                   .inner_diameter_m = 0.05,
                                   .youngs_modulus_pa = 6894.75,
                                   .shear_modulus_pa = 6894.75,
                                   .density_kg_per_m3 = 7810});
  // The order in the file has no influence.
  const model::RotorKit before = files.kit(sleeve + small_ross().substr(small_ross().find("[\"Shaft")));
  EXPECT_EQ(before.shaft[1].youngs_modulus_pa, 211e9);
  EXPECT_LT(difference(before, typed), 1e-14);
  EXPECT_LT(difference(files.kit(small_ross() + sleeve), typed), 1e-14);
}

TEST(RossFile, TapersFlagsShearAndDampingOfAnElementAreThoseOfASegment) {
  const RossFiles files;
  std::string text = small_ross();
  text = replaced(text, "odr = 0.05", "odr = 0.07");
  text = replaced(text, "shear_method_calc = \"cowper\"", "shear_method_calc = \"hutchinson\"");
  text = replaced(text, "gyroscopic = true", "gyroscopic = false");
  text =
      replaced(text, "tag = \"Shaft Element 0\"\n", "tag = \"Shaft Element 0\"\nalpha = 1.5\nbeta = 2e-6\n");
  const std::size_t second = text.find("Shaft Element 1");
  text = text.substr(0, second) +
         replaced(replaced(text.substr(second), "shear_effects = true", "shear_effects = false"),
                  "rotary_inertia = true", "rotary_inertia = false");
  model::RotorKit typed = small_kit();
  typed.shaft[0].outer_diameter_end_m = 0.07;
  typed.shaft[0].shear_coefficient = model::ShearCoefficient::hutchinson;
  typed.shaft[0].gyroscopic = false;
  typed.shaft[0].mass_damping_per_s = 1.5;
  typed.shaft[0].stiffness_damping_s = 2e-6;
  typed.shaft[1].shear_coefficient = model::ShearCoefficient::none;
  typed.shaft[1].rotary_inertia = false;
  EXPECT_LT(difference(files.kit(text), typed), 1e-14);
}

/// Bearing, housing, baseplate, ground and a mass on the shaft, compared with a hand-written matrix of one
/// plane.
TEST(RossFile, ChainsOfLinksAreTheMatrixWrittenDown) {
  const RossFiles files;
  const std::string text = ross_shafts(1, 0.5) + ross_bearing(0, 0, "kxx = [1e6]\nn_link = 2") +
                           ross_bearing(1, 2, "kxx = [2e6]\nkyy = [3e6]\ncxx = [30]\nn_link = 7") +
                           ross_bearing(2, 7, "kxx = [4e6]\nmxx = [0.5]") +
                           ross_bearing(3, 1, "kxx = [8e6]") +
                           "[\"PointMass_a\"]\nn = 2\nmx = 3.0\nmy = 4.0\nmz = 1.0\ntag = \"a\"\n"
                           "[\"PointMass_b\"]\nn = 7\nm = 6.0\ntag = \"b\"\n"
                           "[\"PointMass_c\"]\nn = 1\nm = 2.0\nmx = 2.0\nmy = 5.0\nmz = 1.0\n";
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(files.kit(text), {});
  const structure::BeamElement beam = structure::timoshenko_element(steel(0.5), 0.5);
  Eigen::MatrixXd stiffness_y = Eigen::MatrixXd::Zero(6, 6), mass_y = stiffness_y, damping = stiffness_y;
  stiffness_y.topLeftCorner<4, 4>() = beam.stiffness;
  mass_y.topLeftCorner<4, 4>() = beam.mass;
  stiffness_y(0, 0) += 1e6;
  stiffness_y(0, 4) = stiffness_y(4, 0) = -1e6;
  stiffness_y(4, 4) = 1e6 + 3e6;
  stiffness_y(4, 5) = stiffness_y(5, 4) = -3e6;
  stiffness_y(5, 5) = 3e6 + 4e6;
  stiffness_y(2, 2) += 8e6;
  mass_y(2, 2) += 5;
  mass_y(4, 4) = 4;
  mass_y(5, 5) = 6.5;
  damping(4, 4) = damping(5, 5) = 30;
  damping(4, 5) = damping(5, 4) = -30;
  EXPECT_LT((shaft.plane_stiffness(1) - stiffness_y).norm(), 1e-14 * stiffness_y.norm());
  EXPECT_LT((shaft.plane_mass(1) - mass_y).norm(), 1e-14 * mass_y.norm());
  EXPECT_LT((shaft.support_damping[0][0] - damping).norm(), 1e-14 * damping.norm());
  EXPECT_NEAR(shaft.plane_mass(0)(4, 4), 3, 1e-14);
  EXPECT_NEAR(shaft.plane_stiffness(0)(5, 5), 6e6, 1e-8);
}

TEST(RossFile, TablesGoThroughTheirPoints) {
  const RossFiles files;
  const std::string table =
      "kxx = [1e6, 2e6, 3e6, 4e6,]\nkxy = [-1.0, -2.0, 0, 1]\ncxx = [ 100,]\nfrequency = [100.0, 200.0, 300, "
      "400]";
  for (const std::string speeds : {"frequency", "speed", "w"}) {
    const model::RotorKit kit =
        files.kit(ross_shafts(3, 0.2) + ross_bearing(0, 0, replaced(table, "frequency", speeds)) +
                  ross_bearing(1, 3, "kxx = [2e6]"));
    ASSERT_TRUE(kit.supports.at(0).table) << speeds;
    const model::SupportTable& read = *kit.supports[0].table;
    ASSERT_EQ(read.speed_hz.size(), 4U);
    EXPECT_DOUBLE_EQ(read.speed_hz[2], 300 / (2 * pi));
    EXPECT_EQ(read.columns[0], (std::vector<double>{1e6, 2e6, 3e6, 4e6}));
    EXPECT_EQ(read.columns[1], (std::vector<double>{-1, -2, 0, 1}));
    EXPECT_EQ(read.columns[3], read.columns[0]);  // kyy equals kxx
    EXPECT_EQ(read.columns[4], (std::vector<double>{100, 100, 100, 100}));
    EXPECT_FALSE(kit.supports.at(1).table);
  }
}

/// Speeds of 3000 and 11000 rpm as ROSS saves them, also as ends of a sweep, and two other speeds.
TEST(RossFile, SpeedsOfWholeRevolutionsPerMinuteAreThose) {
  const RossFiles files;
  const std::string table =
      "kxx = [1e6, 2e6, 3e6, 4e6]\nfrequency = [314.1592653591, 350.0, 400.00001, 1151.917306316]";
  const model::RotorKit kit =
      files.kit(ross_shafts(3, 0.2) + ross_bearing(0, 0, table) + ross_bearing(1, 3, table), "rotor.toml",
                {"sweep={speed_rpm: {values: [3000, 11000]}, whirl_ratio: {values: [0.5]}}"});
  EXPECT_EQ(kit.supports.at(0).table->speed_hz,
            (std::vector<double>{50, 350 / (2 * pi), 400.00001 / (2 * pi), 11000.0 / 60}));
}

TEST(RossFile, UnbalanceIsThatOfTheDiscsThatAreNamed) {
  const RossFiles files;
  const std::string text = small_ross() + ross_disc(1, 2, 5, 0.01, 0.01);
  EXPECT_EQ(files.kit(text).discs[1].eccentricity_ratio, 1);
  const model::RotorKit kit = files.kit(text, "rotor.toml",
                                        {"rotor.unbalance=[{disc: Disk 1, eccentricity_ratio: 2, "
                                         "eccentricity_phase_deg: 30}]"});
  EXPECT_EQ(kit.discs[0].eccentricity_ratio, 0);
  EXPECT_EQ(kit.discs[1].eccentricity_ratio, 2);
  EXPECT_EQ(kit.discs[1].eccentricity_phase_deg, 30);
  EXPECT_NE(files.message(text, "rotor.toml", {"rotor.unbalance=[{disc: Disc 1}]"})
                .find("rotor.unbalance.0.disc: 'Disc 1' is unknown (did you mean 'Disk 1'?), allowed: Disk "
                      "0, Disk 1"),
            std::string::npos);
}

TEST(RossFile, ElementsAreNotCut) {
  const RossFiles files;
  EXPECT_EQ(structure::assemble_beam_shaft(files.kit(small_ross()), {}).node_position_m.size(), 4U);
  EXPECT_EQ(files.kit(small_ross(), "rotor.toml", {"rotor.elements=12", "rotor.damping_ratio=0.01"}).elements,
            12);
}

}  // namespace
}  // namespace rubsweep::config::machine
