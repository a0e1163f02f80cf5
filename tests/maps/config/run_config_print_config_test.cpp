#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>
#include <random>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {
namespace {

void expect_round_trip(const RunConfig& config) {
  const std::string printed = print_config(config);
  const RunConfig again = read_run_config_text(printed, "printed.yaml", {});
  EXPECT_EQ(bits_of(again), bits_of(config));
  EXPECT_EQ(again.output_directory, config.output_directory);
  EXPECT_EQ(print_config(again), printed);
}

/// Random positive doubles over most exponents, almost all of which need 17 digits.
double awkward(std::mt19937_64& random) {
  return std::ldexp(1 + std::ldexp(static_cast<double>(random() >> 12), -52),
                    static_cast<int>(random() % 160) - 80);
}

RunConfig awkward_config(std::mt19937_64& random) {
  const auto maybe = [&]() { return random() % 2 == 0 ? std::optional<double>() : awkward(random); };
  RunConfig config;
  config.study.machine.rotor =
      model::JeffcottRotor{awkward(random), awkward(random), std::min(awkward(random), 0.9)};
  for (std::size_t i = 0; i < 1 + random() % 3; ++i) {
    model::Stop stop;
    stop.geometry = model::OneSideGeometry{-awkward(random)};
    stop.contact_radius_m = std::min(awkward(random), 10.);
    stop.clearance_m = std::min(awkward(random), 0.9 * stop.contact_radius_m);
    if (random() % 2 == 0) {
      stop.geometry = model::AnnularGeometry{{stop.clearance_m / 3, -stop.clearance_m / 7}};
    }
    stop.stiffness_n_per_m = awkward(random);
    const double restitution = 1 / (1 + awkward(random) / 1e25);
    const model::ContactDamping dampings[] = {
        model::NominalRestitution{restitution}, model::DeliveredRestitution{restitution},
        model::ExplicitDamping{awkward(random)}, model::RestitutionByRotorMass{restitution}};
    stop.damping = dampings[random() % 4];
    const model::Friction frictions[] = {
        model::NoFriction{}, model::ConstantFriction{restitution},
        model::StribeckFriction{
            {std::min(awkward(random), 9.), awkward(random), 0, -0.0, -awkward(random), 1}}};
    stop.friction = frictions[random() % 3];
    stop.contact_mass_kg = maybe();
    if (random() % 2 == 0) stop.casing = model::Casing{awkward(random), awkward(random), awkward(random)};
    config.study.machine.stops.push_back(stop);
  }
  // No number may look like one in a wrong unit.
  const double frequency_hz = std::get<model::JeffcottRotor>(config.study.machine.rotor).natural_frequency_hz;
  if (random() % 2 == 0)
    config.study.machine.kick =
        model::Kick{awkward(random), std::min(awkward(random), 1e-3 / frequency_hz), maybe()};
  config.study.machine.gravity_m_per_s2 = std::min(awkward(random), 100.);
  config.study.grid.speed_hz = {std::min(awkward(random), 80 * frequency_hz), 1.1e-30,
                                std::min(awkward(random), 90 * frequency_hz)};
  config.study.grid.measure = sweep::UnbalanceMeasure(random() % 2);
  config.study.grid.unbalance = {0.9e30, 0, awkward(random)};
  config.study.solver.method = integrate::run::Method(random() % 3);
  config.study.solver.stepper = integrate::run::Stepper(random() % 6);
  // The exact solver has no smoothed law.
  const bool smoothed = config.study.solver.method != integrate::run::Method::exact && random() % 2 == 1;
  config.study.solver.contact =
      smoothed ? integrate::run::ContactHandling::smoothed : integrate::run::ContactHandling::located;
  config.study.solver.relative_tolerance = 1e-9 * std::numbers::pi;
  config.study.response = {
      .max_revolutions = 1001, .samples_per_revolution = 66, .window_revolutions = 100, .max_order = 16};
  config.study.robustness = sweep::Robustness(random() % 2);
  config.output_directory = "results/awkward";
  return config;
}

TEST(RunConfigPrintConfig, ReadsBackEqualAndPrintsTheSameAgain) {
  expect_round_trip(read_run_config_text(test_file("one_side.yaml"), "one_side.yaml", {}));
  expect_round_trip(read_run_config_text(test_file("minimal.yaml"), "minimal.yaml", {}));
  std::mt19937_64 random(20240607);
  for (int i = 0; i < 200; ++i) expect_round_trip(awkward_config(random));
}

TEST(RunConfigPrintConfig, KeepsEveryDirectory) {
  RunConfig config = read_run_config_text(test_file("minimal.yaml"), "minimal.yaml", {});
  for (const char* directory : {"results/a-b_c.d",
                                "/tmp/x",
                                ".",
                                "...",
                                "../up",
                                "-",
                                "- a",
                                "a: b",
                                "a #b",
                                "~",
                                "null",
                                "Null",
                                "true",
                                "123",
                                "1e3",
                                "'",
                                "\"",
                                "a\"b\\c",
                                "a\nb\r\n",
                                "\t",
                                " a ",
                                "{a}",
                                "[",
                                "r\xC3\xA9sultats",
                                "\xF0\x9F\x8C\x80",
                                "\x01\x7f",
                                "%a",
                                "&a",
                                "*a",
                                "!a",
                                "@",
                                "`"}) {
    config.output_directory = directory;
    expect_round_trip(config);
  }
}

TEST(RunConfigPrintConfig, RefusesADirectoryThatNoYamlFileCanHold) {
  RunConfig config = read_run_config_text(test_file("minimal.yaml"), "minimal.yaml", {});
  config.output_directory = "a\xff";
  EXPECT_THROW(print_config(config), ConfigError);
}

TEST(RunConfigPrintConfig, FitsTheReaderAtItsLargest) {
  std::string text = test_file("minimal.yaml");
  text = replaced(text, "{from: 60, count: 1}", "{from: 10.1, to: 999.7, count: 10000}");
  text = replaced(text, "{values: [0.5]}", "{from: 0.11, to: 0.97, count: 400}");
  expect_round_trip(read_run_config_text(text, "large.yaml", {}));
}

TEST(RunConfigPrintConfigStudy, IsTheConfigurationWithoutItsOutput) {
  RunConfig config = read_run_config_text(test_file("minimal.yaml"), "minimal.yaml", {});
  const std::string study = print_study(config.study);
  EXPECT_EQ(print_config(config), study + "output:\n  directory: results\n  warn_over_clearances: 10\n");
  config.warn_over_clearances = 3;
  EXPECT_EQ(print_study(config.study), study) << "no part of the digest";
}

/// The minimal configuration, which ends with sweep and output, with another sweep.
RunConfig with_sweep(const std::string& speed, const std::string& unbalance) {
  std::string text = test_file("minimal.yaml");
  text = replaced(text, "speed_hz: {from: 60, count: 1}", speed);
  return read_run_config_text(replaced(text, "whirl_ratio: {values: [0.5]}", unbalance), "test.yaml", {});
}

TEST(RunConfigPrintConfig, KeepsAnAxisAsItWasWritten) {
  const RunConfig config = with_sweep("speed_rpm: {from: 3000, to: 11900, count: 2000, scale: log}",
                                      "unbalance_g_mm: {values: [0.1, 240, 33.3]}");
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("  speed_rpm:\n    from: 3000\n    to: 11900\n    count: 2000\n    scale: log\n"
                         "  unbalance_g_mm:\n    values: [0.1, 240, 33.3]\n"),
            std::string::npos)
      << printed;
  expect_round_trip(config);
  const RunConfig again = read_run_config_text(printed, "printed.yaml", {});
  EXPECT_EQ(print_study(again.study), print_study(config.study));
  EXPECT_EQ(print_study(config.study).find("rpm"), std::string::npos) << "no part of the digest";
}

TEST(RunConfigPrintConfig, KeepsAGradeWithItsRatedSpeed) {
  const RunConfig config = with_sweep("speed_hz: {from: 55.5, to: 66.6, count: 11}",
                                      "balance_grade_mm_per_s: {from: 2.5, to: 6.3, count: 7}\n"
                                      "  rated_speed_rpm: 2950");
  EXPECT_NE(print_config(config).find("balance_grade_mm_per_s:\n    from: 2.5\n    to: 6.3\n    count: 7\n"),
            std::string::npos);
  expect_round_trip(config);
}

TEST(RunConfigPrintConfig, SaysInSiWhatOtherUnitsDoNot) {
  RunConfig config =
      with_sweep("speed_rpm: {from: 3000, to: 9000, count: 3}", "whirl_ratio: {values: [0.5]}");
  config.study.grid.speed_hz = {
      50, std::nextafter(50.0, 51.0)};  // two speeds that are equal in rpm with 15 digits
  EXPECT_NE(print_config(config).find("speed_hz:\n    values: [50, 50.00000000000001]"), std::string::npos);
  expect_round_trip(config);
}

TEST(RunConfigPrintConfig, ShowsEveryDefault) {
  const RunConfig config = read_run_config_text(test_file("minimal.yaml"), "minimal.yaml", {});
  EXPECT_EQ(print_config(config), test_file("minimal_printed.yaml"));
}

std::string plain_kit() {
  std::string text = test_file("bad/table_missing.yaml");
  return replaced(text, "table: {file: tables/no_such_table.csv}",
                  "stiffness_x_n_per_m: 3.0e4\n      stiffness_y_n_per_m: 3.1e4");
}

TEST(RunConfigPrintConfigExportedMatrices, ReadBackAsTheSameReducedRotor) {
  const RunConfig typed = read_run_config_text(plain_kit(), "kit.yaml", {});
  const TemporaryDirectory directory;
  const auto files = exported_matrices(typed);
  ASSERT_EQ(files.size(), std::size(exported_matrix_files));
  for (const std::string_view name : exported_matrix_files) {
    ASSERT_TRUE(files.contains(name)) << name;
    std::ofstream(directory.path() / name) << files.at(name);
  }
  const RunConfig read = read_run_config(directory.path() / "rotor.yaml", {});
  EXPECT_EQ(read.output_directory, "results_matrices");
  EXPECT_EQ(read.study.grid.speed_hz, typed.study.grid.speed_hz);
  const structure::Assembly a = structure::assemble_rotor_kit(typed.study.machine).assembly,
                            b = structure::assemble_rotor_kit(read.study.machine).assembly;
  EXPECT_EQ(a.system.mass, b.system.mass);
  EXPECT_EQ(a.system.stiffness, b.system.stiffness);
  EXPECT_EQ(a.system.damping, b.system.damping);
  EXPECT_EQ(a.gyroscopic, b.gyroscopic);
  EXPECT_EQ(a.system.unbalance_kg, b.system.unbalance_kg);
  EXPECT_EQ(exported_matrices(read),
            exported_matrices(read_run_config_text(print_config(read), "printed.yaml", {})));
}

TEST(RunConfigPrintConfigExportedMatrices, OfARotorThatIsVariedAreRefused) {
  const RunConfig config = read_run_config_text(plain_kit(), "kit.yaml",
                                                {"sweep.x={key: rotor.discs.0.mass_kg, values: [0.7, 0.8]}"});
  EXPECT_EQ(::message_of<ConfigError>([&] { exported_matrices(config); }),
            "rotor.discs.0.mass_kg: is varied, and matrices are of one rotor, allowed: keys of other parts "
            "of the machine");
}

}  // namespace
}  // namespace rubsweep::config
