#include "rubtrace/rotor_report_tables.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "core/scene/kit_machine.hpp"

namespace rubsweep::apps {
namespace {

std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::vector<double>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::strtod(cell.c_str(), nullptr));
  }
  return rows;
}

/// Between the nodes of a shaft whose line is a cubic there is the same cubic.
TEST(RotorReportTables, AShapeBetweenNodesIsTheCubicThroughThem) {
  const linear::FreeRotor rotor = linear::free_rotor(scene::light_shaft_machine());
  const auto nodes = static_cast<Eigen::Index>(rotor.position_m.size());
  const std::complex<double> i(0, 1);
  const auto x = [](double z) { return 1 + 2 * z - 30 * z * z * z; };
  const auto slope = [](double z) { return 2 - 90 * z * z; };
  Eigen::VectorXcd response(4 * nodes);
  for (Eigen::Index k = 0; k < nodes; ++k) {
    const double z = rotor.position_m[static_cast<std::size_t>(k)];
    response.segment(4 * k, 4) << x(z), -2.0 * i * x(z), slope(z), -2.0 * i * slope(z);
  }
  const auto rows = numbers_of(deflected_shape_csv(with_places_between(rotor), response));
  EXPECT_GE(rows.size(), 60u);
  for (const std::vector<double>& row : rows) {
    ASSERT_EQ(row.size(), 5u);
    EXPECT_NEAR(row[1], x(row[0]), 1e-12) << row[0];
    EXPECT_NEAR(row[2], 0, 1e-12);
    EXPECT_NEAR(row[4], -2 * x(row[0]), 1e-12);
  }
  EXPECT_EQ(numbers_of(deflected_shape_csv(rotor, response)).size(), rotor.position_m.size());
}

TEST(RotorReportTables, PartsHaveTheNamesOfTheirFileOrTheirNumbers) {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.from_file = true;
  kit.supports[0].name = "BearingElement_Drive end, left";
  kit.supports.push_back(kit.supports[1]);
  kit.supports[2].name = "SealElement_Labyrinth_2";
  kit.supports[2].position_m = 0.1;
  kit.sensors = {{.position_m = 0.1, .name = "DE x"}};
  EXPECT_EQ(support_label(kit, 0), "Drive end, left");
  EXPECT_EQ(support_label(kit, 1), "support 1");
  const std::string parts = rotor_parts_csv(machine);
  for (const char* row :
       {"layer,shaft 0,0,0.4,0,0.01,0,0.01,,,\n", "disc,disc 0,0.2,,,,,,0.8,4e-04,\n",
        "bearing,\"Drive end, left\",0,,,,,,,,\n", "bearing,support 1,0.4,,,,,,,,\n",
        "seal,Labyrinth_2,0.1,,,,,,,,\n", "stop,stop 0,0.2,,,,,,,,\n", "probe,DE x,0.1,,,,,,,,0\n"})
    EXPECT_NE(parts.find(row), std::string::npos) << row << parts;
  kit.discs[0].name = "Impeller";
  EXPECT_NE(rotor_parts_csv(machine).find("disc,Impeller,0.2,"), std::string::npos);
  EXPECT_NE(rotor_parts_csv(machine, {"seal"}).find("stop,seal,0.2,"), std::string::npos);
}

TEST(RotorReportTables, BearingsWithoutATableHaveOneStiffness) {
  model::Machine machine = scene::light_shaft_machine();
  const auto rows = numbers_of(bearing_stiffness_csv(*model::kit_of(machine), std::vector{0.0, 50.0}));
  ASSERT_EQ(rows.size(), 4u);
  for (const std::vector<double>& row : rows) {
    EXPECT_EQ(row[2], 3e4);
    EXPECT_EQ(row[3], 3e4);
  }
}

TEST(RotorReportTables, WithoutForcesTheirCellsAreEmpty) {
  design::StaticLine line{true, {0, 1}, {Eigen::Vector2d(0, 0), Eigen::Vector2d(-1e-5, -2e-5)}, {}, {}};
  EXPECT_EQ(static_line_csv(line),
            "position_m,deflection_x_m,deflection_y_m,shear_x_n,shear_y_n,moment_x_nm,moment_y_nm\n"
            "0,0,-1e-05,,,,\n1,0,-2e-05,,,,\n");
}

TEST(RotorReportTables, NotesAreQuotedAndMayHaveARange) {
  EXPECT_EQ(report_notes_csv({{"rotor", "left out: a, b"}, {"operating", "from here", 10, 20}}),
            "picture,note,from_hz,to_hz\nrotor,\"left out: a, b\",,\noperating,from here,10,20\n");
}

}  // namespace
}  // namespace rubsweep::apps
