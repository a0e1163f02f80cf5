#include "rubsweep/maps/report/cells_of_rows.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::report {
namespace {

/// Two speeds, falling, three eccentricities in no order, and an axis of two keys, the first of which stays.
const sweep::Grid grid{{60, 50},
                       sweep::UnbalanceMeasure::eccentricity_m,
                       {1e-5, 3e-5, 2e-5},
                       {{{"kick.angle_deg", "kick.force_n"}, {0, -2}, {100, 300}}}};
const std::string header = "class,kick.force_n,kick.angle_deg,eccentricity_m,speed_hz\n";

std::string row(std::size_t cell) {
  const std::vector<std::string> unbalances{"1e-05", "3e-5", "0.00002"};
  return "chaotic," + std::string(cell < 6 ? "-200" : "-600") + ",0," + unbalances[cell / 2 % 3] + "," +
         (cell % 2 == 0 ? "60" : "50.0") + "\n";
}

/// The cells of the rows of a map, which must be all when `whole`.
std::vector<std::size_t> cells_of(const std::string& rows, bool whole = false) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "map.csv";
  std::ofstream(path, std::ios::binary) << "# a comment\n" << header << rows;
  batch::CsvReader map(path);
  CellsOfRows cells(map, grid);
  std::vector<std::size_t> found;
  while (map.next()) found.push_back(cells.take(map));
  EXPECT_EQ(cells.taken(), found.size());
  if (whole) cells.require_all();
  return found;
}

std::string problem(const std::string& rows, bool whole = false) {
  const std::string text = message_of<IoError>([&] { cells_of(rows, whole); });
  return text.substr(text.find("map.csv"));
}

TEST(CellsOfRows, ComeFromTheValuesWhateverTheOrder) {
  std::string rows;
  std::vector<std::size_t> shuffled;
  for (std::size_t i = 0; i < 12; ++i) {
    shuffled.push_back(5 * i % 12);
    rows += row(shuffled.back());
  }
  EXPECT_EQ(cells_of(rows, true), shuffled);
}

TEST(CellsOfRows, ACellIsThereOnceAtMost) {
  EXPECT_EQ(problem(row(0) + row(7) + row(0)),
            "map.csv:5: the row of speed_hz 60, eccentricity_m 1e-05, kick.angle_deg 0, kick.force_n -200 is "
            "there twice");
}

TEST(CellsOfRows, WhatIsNoCellHasItsPlace) {
  const std::string unknown = " is no cell of its configuration";
  EXPECT_EQ(problem("chaotic,-200,0,1e-5,61\n"),
            "map.csv:3: the row of speed_hz 61, eccentricity_m 1e-5, kick.angle_deg 0, kick.force_n -200" +
                unknown);
  EXPECT_EQ(problem("chaotic,-200,1,1e-5,60\n"),
            "map.csv:3: the row of speed_hz 60, eccentricity_m 1e-5, kick.angle_deg 1, kick.force_n -200" +
                unknown);
  EXPECT_EQ(
      problem("chaotic,-200,0,,60\n"),
      "map.csv:3: the row of speed_hz 60, eccentricity_m , kick.angle_deg 0, kick.force_n -200" + unknown);
}

TEST(CellsOfRows, AMissingOneIsNamed) {
  std::string rows;
  for (std::size_t cell = 0; cell < 12; ++cell) rows += cell == 9 ? "" : row(cell);
  EXPECT_EQ(problem(rows, true),
            "map.csv: holds 11 cells of 12, there is no row of speed_hz 50, eccentricity_m 3e-05, "
            "kick.angle_deg 0, kick.force_n -600");
}

}  // namespace
}  // namespace rubsweep::report
