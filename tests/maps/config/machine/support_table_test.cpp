#include <filesystem>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

const model::Support& tabled(const RunConfig& config) {
  return model::kit_of(config.study.machine)->supports.at(1);
}

TEST(SupportTable, ReadsUnitsAndLeavesZeros) {
  const RunConfig config = read_run_config_text(test_file("support_table.yaml"), "test.yaml", {});
  ASSERT_TRUE(tabled(config).table);
  const model::SupportTable& table = *tabled(config).table;
  EXPECT_EQ(table.speed_hz, (std::vector<double>{20, 40, 60, 80}));
  EXPECT_EQ(table.columns[0], (std::vector<double>{3e4, 3.1e4, 3.3e4, 3.4e4}));
  EXPECT_DOUBLE_EQ(table.columns[1][2], 3e3);
  EXPECT_EQ(table.columns[2], (std::vector<double>{0, 0, 0, 0}));
  EXPECT_EQ(table.columns[3][3], 3.2e4);
  EXPECT_DOUBLE_EQ(table.columns[4][3], 70);
  EXPECT_EQ(table.columns[9], (std::vector<double>{0.1, 0.1, 0.1, 0.1}));
  EXPECT_EQ(tabled(config).stiffness_x_n_per_m, 3.3e4) << "of the middle speed";
}

TEST(SupportTable, FromAFileIsPrintedInlineAndReadsBackTheSame) {
  const TemporaryDirectory directory;
  const std::string folder = directory.path().string();
  std::filesystem::create_directories(folder + "/tables");
  std::ofstream(folder + "/tables/film.csv")
      << "\xEF\xBB\xBF# of a supplier\n\nspeed_rpm , kxx_n_per_mm, "
         "kyy_n_per_mm,cxx_ns_per_m\r\n1200,30,31,5\r\n4800,33.3,32,6\n";
  const std::string text =
      replaced(test_file("bad/table_missing.yaml"), "tables/no_such_table.csv", "tables/film.csv");
  const RunConfig config = read_run_config_text(text, folder + "/my.yaml", {});
  ASSERT_TRUE(tabled(config).table);
  EXPECT_EQ(tabled(config).table->columns[0], (std::vector<double>{3e4, 33.3 * 1e3}));
  EXPECT_EQ(tabled(config).table->columns[4], (std::vector<double>{5, 6}));
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("speed_hz: [20, 80]"), std::string::npos) << printed;
  EXPECT_EQ(printed.find("film.csv"), std::string::npos);
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
}

/// Tests tables read from a file with given bytes, or the error messages.
class SupportTableFile : public testing::Test {
 protected:
  RunConfig config_of(const std::string& bytes) const {
    std::ofstream(directory_.path() / "film.csv", std::ios::binary) << bytes;
    return read_run_config_text(
        replaced(test_file("bad/table_missing.yaml"), "tables/no_such_table.csv", "film.csv"),
        (directory_.path() / "my.yaml").string(), {"rotor.elements=4"});
  }
  std::string problem_of(const std::string& bytes) const {
    const std::string message = ::message_of<ConfigError>([&] { config_of(bytes); });
    return message.substr(message.find("film.csv"));
  }
  void expect_table(const std::string& bytes) const {
    const RunConfig config = config_of(bytes);
    ASSERT_TRUE(tabled(config).table) << bytes;
    const model::SupportTable& table = *tabled(config).table;
    ASSERT_EQ(table.speed_hz.size(), 2u) << bytes;
    const auto expect_near = [&](double value, double expected) {
      EXPECT_NEAR(value, expected, 1e-9 * expected) << bytes;
    };
    expect_near(table.speed_hz[0], 20);
    expect_near(table.speed_hz[1], 80);
    expect_near(table.columns[0][0], 3.0e4);
    expect_near(table.columns[0][1], 3.35e4);
    expect_near(table.columns[3][1], 3.2e4);
    expect_near(table.columns[4][0], 5);
  }
  /// The configuration with a unit of speed beside the file name, and the table's speed in Hz.
  RunConfig config_in(const std::string& unit, const std::string& speed, const std::string& bytes) const {
    std::ofstream(directory_.path() / "film.csv", std::ios::binary) << bytes;
    return read_run_config_text(replaced(test_file("bad/table_missing.yaml"), "tables/no_such_table.csv",
                                         "film.csv, speed_unit: " + unit),
                                (directory_.path() / "my.yaml").string(),
                                {"rotor.elements=4", "sweep.speed_hz={values: [" + speed + "]}"});
  }
  const TemporaryDirectory directory_;
};

TEST_F(SupportTableFile, AreReadAsPeopleHaveThem) {
  expect_table("speed_rpm;kxx;kyy;cxx\n1200;3,0e4;31000;5\n4800;3,35e4;32000;6\n");
  expect_table("speed_rpm\tkxx\tkyy\tcxx\r\n1200\t3e4\t3.1e4\t5\r\n4800\t33500\t32000\t6\r\n");
  expect_table(
      "\xEF\xBB\xBF\"speed_rpm\",\"kxx\",\"kyy\",\"cxx\"\n1200,3e4,3.1e4,5\n4800,33500,32000,6\n,,,\n");
  expect_table(
      "A bearing of somebody; drawing 7\n\nSpeed [Hz];Kxx [N/mm];Kyy [kN/m];Cxx [N-s/m];Remark\n"
      "20;30,0;31;5;cold\n80;33,5;32;6;\n");
  expect_table("speed_rpm,kxx,kyy,cxx\nrpm,N/\xB5m,MN/m,N s/m\n1200,0.03,0.031,5\n4800,0.0335,0.032,6\n");
  expect_table(
      "# omega (rad/s), kxx, kyy, cxx\n125.66370614359172,3e4,3.1e4,5\n502.6548245743669,33500,32000,6\n");
  expect_table(
      "speed_hz,kxx_lbf_per_in,Kyy [lbf/in],Cxx [lbf.s/in]\n"
      "20,171.304414642,177.0145617967,0.02855073577366\n80,191.2899296835,182.7247089514,0.0342608829284\n");
  expect_table("speed_hz,kxx,kyy,cxx\n80,33500,32000,6\n20,30000,31000,5\n");
}

TEST_F(SupportTableFile, AreReadFromFurtherSuppliers) {
  expect_table(
      "  Speed [rpm]  Kxx [N/m]  Kyy [N/m]  Cxx [N s/m]\n 1200.0 3.0D+04 3.1D+04 5.0\n 4800.0 3.35D+04 "
      "3.2D+04 6.0\n");
  expect_table("# speed_hz kxx kyy cxx\n2.0e+01 3e4 3.1e4 5\n8.0e+01 33500 32000 6\n");
  expect_table(
      "Speed / rpm;K_xx / (N/m);K_yy / (N/m);C_xx / (N s/m);\n1200;3e4;3.1e4;5;\n4800;33500;32000;6;\n");
  expect_table(
      "\u03a9 [rad/s],Kxx [N/m],Kyy [N/m],Cxx [kN\u00b7s/m]\n125.66370614359172,3e4,3.1e4,0.005\n"
      "502.6548245743669,33500,32000,0.006\n");
  expect_table(
      "Speed,Stiffness,Stiffness,Damping\n[rpm],Kxx [N/m],Kyy [N/m],Cxx [Ns/m]\n1200,3e4,3.1e4,5\n"
      "4800,33500,32000,6\n");
  expect_table("n [1/s],kxx,kyy,cxx\n20,3e4,3.1e4,5\n80,33500,32000,6\n");
  // A row that repeats the previous one adds nothing.
  expect_table(
      "speed_hz,kxx,kyy,cxx\n20,3e4,3.1e4,5\n20,3e4,3.1e4,5\n80,33500,32000,6\n80,33500,32000,6\n,,,\n");
  expect_table("speed_hz,kxx,kyy,cxx\n80,33500,32000,6\n80,33500,32000,6\n20,3e4,3.1e4,5\n");
}

TEST_F(SupportTableFile, WhatMayMeanTwoThingsIsRefusedAtItsCell) {
  EXPECT_EQ(problem_of("Omega [1/s],kxx,kyy\n1,2,3\n2,2,3\n").substr(0, 70),
            "film.csv:1:1: rotor.supports.1.table.file: the unit of 'Omega [1/s]' i");
  EXPECT_EQ(problem_of("speed_rpm,kxx,kyy\n\"1,000\",2e4,3e4\n\"2,000\",2e4,3e4\n"),
            "film.csv:2:2: rotor.supports.1.table.file: '1,000' may have a decimal comma, or commas between "
            "thousands, allowed: numbers without signs between thousands");
  EXPECT_EQ(problem_of("speed_rpm,kxx,kyy\n3,2,3\n4,2,3\n4,2,5\n5,2,3\n"),
            "film.csv:4:1: rotor.supports.1.table.speed_rpm.2: 4 is not above the speed before it, allowed: "
            "speeds that rise");
  EXPECT_EQ(problem_of("speed_rpm,kxx,kyy\n3,2,3\n3,2,3\n4,2,5\n4,2,6\n"),
            "film.csv:5:1: rotor.supports.1.table.speed_rpm.3: 4 is not above the speed before it, allowed: "
            "speeds that rise");
  EXPECT_EQ(problem_of("speed_rpm,kxx,kxy,kyy\n3,2,,3\n4,2,1,3\n"),
            "film.csv:2:5: rotor.supports.1.table.kxy.0: '' is not a number, allowed: a finite number");
}

TEST_F(SupportTableFile, UnitsThatAreMissingOrContradictAreRefused) {
  EXPECT_EQ(problem_of("Omega,kxx,kyy\n1,2,3\n2,2,3\n"),
            "film.csv:1:1: rotor.supports.1.table.file: 'Omega' says no unit, allowed: rpm, Hz or rad/s "
            "behind it or below it, or as speed_unit beside file");
  EXPECT_EQ(problem_of("speed_rpm,kxx_n_per_mm,kyy\nrpm,N/m,N/m\n1,2,3\n2,2,3\n"),
            "film.csv:1:11: rotor.supports.1.table.file: the unit of 'kxx_n_per_mm [N/m]' is unknown, or "
            "another one "
            "than it says, allowed: N/m, N/mm, N/um, lbf/in; N s/m, N s/mm, lbf s/in; kg");
  EXPECT_EQ(problem_of("Speed [rpm],kxx,kyy [mN/m]\n1,2,3\n2,2,3\n").substr(0, 14), "film.csv:1:17:");
  EXPECT_EQ(problem_of("speed_rpm;kxx;kyy\n1;2.5;3\n2;2,5;3\n"),
            "film.csv:3:3: rotor.supports.1.table.file: '2,5' has a decimal comma, and numbers before it "
            "have points, "
            "allowed: points as in line 2, or commas, in all numbers");
  EXPECT_EQ(problem_of("speed_rpm,kxx,kyy\n3,2,3\n2,2,3\n2.5,2,3\n"),
            "film.csv:4:1: rotor.supports.1.table.speed_rpm.2: 2.5 is not below the speed before it, "
            "allowed: speeds "
            "that rise, or that fall");
  EXPECT_EQ(
      problem_of("Bearing DE\n 4 0 0\n 1 100.0\n 1e7 0 0 1e7\n"),
      "film.csv:2:1: rotor.supports.1.table.file: no line of the file has names of columns that are known, "
      "and numbers begin with '4', allowed: a line of names as the keys are, perhaps with units, then lines "
      "of numbers");
}

TEST_F(SupportTableFile, TakeTheUnitOfTheirSpeedsFromBesideTheirName) {
  const std::string bytes =
      "#Omega\t Kxx\t Kxy\t Kyx\t Kyy\n600\t 1.1e5\t 0.0\t 0.0\t 1.2e5\n6000\t 1.2e5\t 0\t 0\t 1.3e5\n";
  EXPECT_EQ(tabled(config_in("rpm", "50", bytes)).table->speed_hz, (std::vector<double>{10, 100}));
  EXPECT_EQ(tabled(config_in("Hz", "700", bytes)).table->speed_hz, (std::vector<double>{600, 6000}));
  EXPECT_NEAR(tabled(config_in("rad/s", "700", bytes)).table->speed_hz[1], 954.929658551372, 1e-12 * 955);
  const auto problem = [&](const std::string& unit, const std::string& of) {
    return ::message_of<ConfigError>([&] { config_in(unit, "50", of); });
  };
  EXPECT_NE(problem("deg/s", bytes)
                .find("my.yaml:10:43: rotor.supports.1.table.speed_unit: 'deg/s' is no unit of "
                      "speeds, allowed: rpm, Hz or rad/s"),
            std::string::npos)
      << problem("deg/s", bytes);
  EXPECT_NE(
      problem("rpm", "speed_hz,kxx,kyy\n1,2,3\n2,2,3\n")
          .find(
              "table.speed_unit: is given, and the file says the unit of its speeds, allowed: no speed_unit"),
      std::string::npos);
}

TEST(SupportTable, ANumberOfItCanBeSetAndSwept) {
  const RunConfig set = read_run_config_text(test_file("support_table.yaml"), "test.yaml",
                                             {"rotor.supports.1.table.kyy.2=4.0e4"});
  EXPECT_EQ(tabled(set).table->columns[3][2], 4e4);
}

}  // namespace
}  // namespace rubsweep::config::machine
