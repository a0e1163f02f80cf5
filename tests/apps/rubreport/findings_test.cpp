#include "rubreport/findings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "rubsweep/core/error.hpp"

namespace rubsweep::page {
namespace {

using Cells = std::vector<std::size_t>;

/// A refined grid of 5 x 3 cells in one block, with a lattice of every fourth cell, and a further axis over a
/// key.
sweep::Grid lattice_grid() {
  sweep::Grid grid{{10, 20, 30, 40, 50}, sweep::UnbalanceMeasure::whirl_ratio, {0.1, 0.2, 0.3}};
  grid.axes = {{{"kick.force_n"}, {1}, {100}}};
  grid.refinement = sweep::Refinement{2, 0};
  return grid;
}

/// A map with rows for these cells, each with its class.
MapTable map_of(const Cells& cells, const std::vector<std::string>& classes) {
  MapTable map{"1.2.3", "digest", cells.size(), {}};
  map.columns = {{"speed_hz", {}, {}},    {"whirl_ratio", {}, {}}, {"class", {}, classes},  {"order", {}, {}},
                 {"revolutions", {}, {}}, {"status", {}, {}},      {"kick.force_n", {}, {}}};
  map.cells = cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    map.columns[0].numbers.push_back(10.0 * static_cast<double>(cells[i] % 5 + 1));
    map.columns[1].numbers.push_back(lattice_grid().unbalance[cells[i] / 5]);
    map.columns[3].numbers.push_back(classes[i] == "subharmonic" ? 2 : std::nan(""));
    map.columns[4].numbers.push_back(100 + static_cast<double>(i));
    map.columns[5].words.emplace_back("ok");
    map.columns[6].numbers.push_back(100);
  }
  return map;
}

TEST(FindingsPaintedTable, GivesTheCellsOfAUniformBlockItsClassAndNothingElse) {
  const Cells corners{0, 4, 10, 14};
  const PaintedTable painted =
      painted_table(map_of(corners, std::vector<std::string>(4, "subharmonic")), lattice_grid());
  EXPECT_EQ(painted.computed, corners);
  ASSERT_EQ(painted.map.rows, 15U);
  EXPECT_EQ(painted.map.word("class", 7), "subharmonic");
  EXPECT_EQ(painted.map.number("order", 7), 2);
  EXPECT_EQ(painted.map.number("speed_hz", 7), 30);
  EXPECT_EQ(painted.map.number("whirl_ratio", 7), 0.2);
  EXPECT_EQ(painted.map.number("kick.force_n", 7), 100);
  EXPECT_EQ(painted.map.word("status", 7), not_computed);
  EXPECT_FALSE(painted.map.number("revolutions", 7));
  EXPECT_EQ(painted.labels[7], sweep::unknown_label);
  // Computed cells are unchanged.
  EXPECT_EQ(painted.map.word("status", 10), "ok");
  EXPECT_EQ(painted.map.number("revolutions", 10), 102);
}

TEST(FindingsPaintedTable, RefusesAMapThatLacksACell) {
  const auto without = [](const Cells& cells) {
    return painted_table(map_of(cells, std::vector<std::string>(cells.size(), "subharmonic")),
                         lattice_grid());
  };
  EXPECT_NO_THROW(without({0, 4, 10, 14}));
  EXPECT_THROW(without({0, 4, 10}), IoError);
}

TEST(FindingsPaintedTable, PaintsEachBlockByItself) {
  // The right half has another class; the block was split at the middle column.
  const Cells cells{0, 2, 4, 5, 7, 9, 10, 12, 14};
  std::vector<std::string> classes;
  for (const std::size_t cell : cells) classes.emplace_back(cell % 5 < 3 ? "non_contact" : "chaotic");
  const Cells more{3, 8, 13};
  Cells all = cells;
  for (const std::size_t cell : more) {
    all.push_back(cell);
    classes.emplace_back("chaotic");
  }
  const PaintedTable painted = painted_table(map_of(all, classes), lattice_grid());
  EXPECT_EQ(painted.map.word("class", 1), "non_contact");
  EXPECT_EQ(painted.map.word("class", 8), "chaotic");
  EXPECT_EQ(painted.computed, (Cells{0, 2, 3, 4, 5, 7, 8, 9, 10, 12, 13, 14}));
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Two speeds by two whirl ratios: one cell at rest, two motions with contact, and a chaotic one.
MapTable four_cells() {
  return {"1",
          "d",
          4,
          {{"speed_hz", {50, 80, 50, 80}, {}},
           {"whirl_ratio", {0.2, 0.2, 0.6, 0.6}, {}},
           {"class", {}, {"non_contact", "subharmonic", "subharmonic", "chaotic"}},
           {"order", {none, 2, 2, none}, {}},
           {"proof", {}, {"rest", "floquet", "floquet", "observed"}},
           {"robust", {}, {"yes", "yes", "no", "no"}},
           {"contact_fraction", {0, 0.1, 0.2, 0.3}, {}},
           {"peak_contact_force_n", {0, 100, 400, 300}, {}},
           {"peak_displacement_m", {1e-4, 2e-3, 3e-3, 4e-3}, {}}}};
}

const sweep::Grid grid{{50, 80}, sweep::UnbalanceMeasure::whirl_ratio, {0.2, 0.6}};

bool says(const std::vector<std::string>& sentences, const std::string& sentence) {
  return std::find(sentences.begin(), sentences.end(), sentence) != sentences.end();
}

TEST(Findings, SayWhatTheMapHolds) {
  const auto said = findings(four_cells(), grid);
  for (const char* sentence :
       {"4 cells: 2 speeds from 50 to 80 Hz (3000 to 4800 rpm), 2 whirl ratios from 0.2 to 0.6.",
        "Rub lasts in 3 cells (75.0 %), from 50 to 80 Hz (3000 to 4800 rpm); the smallest unbalance with it "
        "is whirl ratio "
        "0.2, "
        "at 80 Hz (4800 rpm).",
        "The most frequent rub is subharmonic 1/2: 2 cells (50.0 %), from 50 to 80 Hz (3000 to 4800 rpm).",
        "The largest contact force is 400 N, at 50 Hz (3000 rpm) and whirl ratio 0.6 (subharmonic 1/2).",
        "The largest displacement is 4 mm, at 80 Hz (4800 rpm) and whirl ratio 0.6 (chaotic).",
        "Chaos, by a positive Lyapunov exponent, is found in 1 cell (25.0 %).",
        "A kick that differs by a millionth leads to another class in 2 cells (50.0 %)."}) {
    EXPECT_TRUE(says(said, sentence)) << sentence << "\n" << testing::PrintToString(said);
  }
}

TEST(Findings, AQuietMapSaysSo) {
  MapTable map = four_cells();
  for (auto& column : map.columns) {
    if (column.name == "class") column.words.assign(4, "non_contact");
    if (column.name == "contact_fraction") column.numbers.assign(4, 0);
  }
  EXPECT_TRUE(says(findings(map, grid), "Rub lasts in no cell."));
}

}  // namespace

}  // namespace rubsweep::page
