#include "rubsweep_compare/compare_maps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "maps/batch/message_of.hpp"
#include "maps/batch/read_csv.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep_compare/comparison_figure.hpp"
#include "rubsweep_compare/describe_comparison.hpp"

namespace rubsweep::apps {
namespace {

using report::map_comments, report::map_header, report::map_line;
using sweep::Row;
using enum CellVerdict;

Row row(double speed_hz, double whirl_ratio, response::motion::MotionClass motion_class,
        std::optional<int> order) {
  Row row;
  row.speed_hz = speed_hz;
  row.whirl_ratio = whirl_ratio;
  row.eccentricity_m = whirl_ratio * 1e-3 / speed_hz;
  row.motion_class = motion_class;
  row.order = order;
  row.measures.emplace();
  row.measures->turns = 64;
  row.measures->contact = {
      .hits = 32, .contact_fraction = 0.1, .peak_displacement_m = 2e-3, .peak_contact_force_n = 500};
  row.measures->amplitude_1x_forward_m = 1e-3;
  row.measures->amplitude_1x_backward_m = 8e-22;
  row.measures->orbit = response::spectrum::OrbitKind::oval;
  return row;
}

/// Four cells: two periodic motions, one at rest and one chaotic.
std::vector<Row> cells() {
  using enum response::motion::MotionClass;
  return {row(50, 0.2, subharmonic, 2), row(60, 0.2, non_contact, {}), row(50, 0.4, chaotic, {}),
          row(60, 0.4, subharmonic, 3)};
}

class CompareMaps : public testing::Test {
 protected:
  std::filesystem::path table(const std::string& name, const std::vector<Row>& rows) const {
    std::string text = "# rubsweep 1\n# digest digest\n" + map_comments() + map_header() + "\n";
    for (const Row& row : rows) text += map_line(row) + "\n";
    return table_of(name, text);
  }

  std::filesystem::path table_of(const std::string& name, const std::string& text) const {
    batch::write_whole_file(directory_.path() / name, text);
    return directory_.path() / name;
  }

  MapComparison compare(const std::vector<Row>& a, const std::vector<Row>& b, double tolerance = 1e-4) const {
    return compare_maps(table("a.csv", a), table("b.csv", b), tolerance);
  }

  const TemporaryDirectory directory_;
};

std::vector<CellVerdict> verdicts(const MapComparison& comparison) {
  std::vector<CellVerdict> verdicts;
  for (const ComparedCell& cell : comparison.cells) verdicts.push_back(cell.verdict);
  return verdicts;
}

TEST_F(CompareMaps, EqualMapsAreEqual) {
  const MapComparison comparison = compare(cells(), cells(), 0);
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(comparison.axis, "whirl_ratio");
  EXPECT_EQ(
      describe_comparison(comparison, 0),
      "4 cells: 4 equal, 0 with another class, 0 with other numbers (beyond 0), 0 in one map only\nequal\n");
}

TEST_F(CompareMaps, KeysSayWhichCellItIs) {
  sweep::Study study;
  study.grid.axes = {{{"kick.force_n"}, {1}, {100, 200}}};
  auto map = [&](const std::string& name, double other_force_n) {
    std::string text = "# rubsweep 1\n# digest digest\n" + map_comments(study) + map_header(study) + "\n";
    for (const double force_n : {100.0, other_force_n}) {
      Row cell = cells()[0];
      cell.key_values = {force_n};
      text += map_line(cell) + "\n";
    }
    return table_of(name, text);
  };
  EXPECT_TRUE(compare_maps(map("a.csv", 200), map("b.csv", 200), 0).equal());
  const MapComparison moved = compare_maps(map("a.csv", 200), map("b.csv", 300), 0);
  EXPECT_EQ(verdicts(moved), (std::vector{equal, only_in_one, only_in_one}));
  EXPECT_NE(describe_comparison(moved, 0).find(
                "speed_hz 50, whirl_ratio 0.2, kick.force_n 300: no such cell -> subharmonic 1/2"),
            std::string::npos);
  EXPECT_THROW(compare_maps(map("a.csv", 200), table("plain.csv", cells()), 0), IoError);
}

TEST_F(CompareMaps, ClassAndOrderMustBeTheSame) {
  auto other = cells();
  other[0].order = 4;
  other[1].motion_class = response::motion::MotionClass::unsettled;
  const MapComparison comparison = compare(cells(), other);
  EXPECT_FALSE(comparison.equal());
  EXPECT_EQ(verdicts(comparison), (std::vector{classes_differ, classes_differ, equal, equal}));
  EXPECT_EQ(
      describe_comparison(comparison, 1e-4),
      "4 cells: 2 equal, 2 with another class, 0 with other numbers (beyond 0.0001), 0 in one map only\n"
      "  speed_hz 50, whirl_ratio 0.2: subharmonic 1/2 -> subharmonic 1/4\n"
      "  speed_hz 60, whirl_ratio 0.2: non_contact -> unsettled\n"
      "different\n");
}

TEST_F(CompareMaps, NumbersMayDifferByTheTolerance) {
  auto other = cells();
  other[0].measures->contact.peak_contact_force_n *= 1.002;
  other[3].measures->contact.peak_contact_force_n *= 1.004;
  EXPECT_TRUE(compare(cells(), other, 5e-3).equal());
  const MapComparison comparison = compare(cells(), other, 1e-3);
  EXPECT_EQ(verdicts(comparison), (std::vector{numbers_differ, equal, equal, numbers_differ}));
  ASSERT_EQ(comparison.columns.size(), 1u);
  const ColumnDifference& force = comparison.columns[0];
  EXPECT_EQ(force.column, "peak_contact_force_n");
  EXPECT_EQ(force.cells, 2u);
  EXPECT_EQ(force.cell, 3u) << "the worst";
  EXPECT_NEAR(force.largest.value(), 0.004 / 1.004, 1e-9);
  EXPECT_NE(describe_comparison(comparison, 1e-3)
                .find("  peak_contact_force_n: 2 cells, largest 0.004 at speed_hz 60, "
                      "whirl_ratio 0.4: 500 -> 502\ndifferent\n"),
            std::string::npos);
}

TEST_F(CompareMaps, LengthsAreRelativeToThePeakDisplacement) {
  auto other = cells();
  other[1].measures->amplitude_1x_backward_m = 9e-20;
  EXPECT_TRUE(compare(cells(), other).equal()) << "rounding of nothing";
  other[1].measures->amplitude_1x_backward_m = 2.1e-3 * 1e-4;
  EXPECT_EQ(compare(cells(), other).columns.at(0).column, "amplitude_1x_backward_m");
}

TEST_F(CompareMaps, WordsAndEmptyNumbersOfARepeatingMotionMustBeTheSame) {
  auto other = cells();
  other[0].measures->orbit = response::spectrum::OrbitKind::complex;
  other[1].measures->comb_spacing = 0.3;
  const MapComparison comparison = compare(cells(), other);
  EXPECT_EQ(verdicts(comparison), (std::vector{numbers_differ, numbers_differ, equal, equal}));
  EXPECT_NE(describe_comparison(comparison, 1e-4)
                .find("orbit: 1 cells, first at speed_hz 50, whirl_ratio 0.2: oval -> complex"),
            std::string::npos);
  EXPECT_NE(describe_comparison(comparison, 1e-4)
                .find("comb_spacing: 1 cells, first at speed_hz 60, whirl_ratio 0.2: empty -> 0.3"),
            std::string::npos);
}

TEST_F(CompareMaps, MotionsThatNeverRepeatHaveNoNumbers) {
  auto other = cells();
  other[2].measures->contact.peak_contact_force_n *= 2;
  EXPECT_TRUE(compare(cells(), other).equal());
}

TEST_F(CompareMaps, HowLongATransientLastedIsNotCompared) {
  auto other = cells();
  other[0].revolutions = 999;
  other[0].last_contact_revolution = 77;
  other[0].proof = response::motion::Proof::observed;
  EXPECT_TRUE(compare(cells(), other).equal());
}

/// A map of an earlier version lacks the columns that were added later.
TEST_F(CompareMaps, ColumnsThatOneMapLacksAreNotCompared) {
  const auto without = [](const std::string& text) {
    std::string older;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      std::string line = text.substr(at, end - at);
      // Removes the peaks and the columns after them: life of chaos, and kind.
      for (int column = 0; !line.starts_with('#') && column < 5; ++column) line.resize(line.rfind(','));
      older += line + '\n';
      at = end + 1;
    }
    return older;
  };
  auto rows = cells();
  rows[0].measures->contact.peak_casing_displacement_m = 1e-4;
  const auto newer = table("newer.csv", rows);
  std::ifstream file(newer);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto comparison = compare_maps(newer, table_of("older.csv", without(text)), 1e-9);
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(comparison.missing_columns,
            (std::vector<std::string>{"peak_casing_displacement_m", "peak_over_clearance"}));
  EXPECT_NE(describe_comparison(comparison, 1e-9)
                .find("not compared: peak_casing_displacement_m, peak_over_clearance, which only one of the "
                      "maps has\n"),
            std::string::npos);
}

TEST_F(CompareMaps, ListedCellsAreLeftOut) {
  auto other = cells();
  other[0].order = 4;
  const auto list = table_of("list.csv", "# why\nspeed_hz,whirl_ratio\n50,0.2\n60,0.4\n");
  const auto comparison = compare_maps(table("a.csv", cells()), table("b.csv", other), 0, list);
  EXPECT_TRUE(comparison.equal());
  EXPECT_EQ(verdicts(comparison), (std::vector{sensitive, equal, equal, sensitive}));
  EXPECT_NE(describe_comparison(comparison, 0)
                .find("not compared: 2 sensitive cells, 1 of them with another class\n"),
            std::string::npos);
}

TEST_F(CompareMaps, CellsThatAreNotRobustAreLeftOut) {
  auto other = cells();
  other[0].order = 4;
  other[3].order = 4;
  const auto with_robust = [&](const std::string& name, const std::vector<Row>& rows,
                               const std::map<std::size_t, std::string>& robust) {
    batch::CsvTable table = batch::read_csv(this->table(name, rows));
    for (const auto& [row, word] : robust) table.rows[row][batch::column(table, "robust")] = word;
    std::string text = map_header() + "\n";
    for (const auto& row : table.rows) text += batch::csv_row(row) + "\n";
    return table_of(name, text);
  };
  const auto a = with_robust("a.csv", cells(), {{0, "no"}, {3, "yes"}});
  const auto b = with_robust("b.csv", other, {{1, "no"}});
  EXPECT_EQ(verdicts(compare_maps(a, b, 0)), (std::vector{sensitive, sensitive, equal, classes_differ}));
}

TEST_F(CompareMaps, CellsOfOneMapOnlyAreADifference) {
  auto some = cells();
  some.pop_back();
  std::reverse(some.begin(), some.end());
  const MapComparison fewer = compare(cells(), some), more = compare(some, cells());
  EXPECT_EQ(verdicts(fewer), (std::vector{equal, equal, equal, only_in_one}));
  EXPECT_EQ(verdicts(more), (std::vector{equal, equal, equal, only_in_one}))
      << "the order of rows means nothing";
  EXPECT_FALSE(fewer.equal());
  EXPECT_NE(
      describe_comparison(fewer, 0).find("  speed_hz 60, whirl_ratio 0.4: subharmonic 1/3 -> no such cell\n"),
      std::string::npos);
  EXPECT_NE(
      describe_comparison(more, 0).find("  speed_hz 60, whirl_ratio 0.4: no such cell -> subharmonic 1/3\n"),
      std::string::npos);
}

TEST_F(CompareMaps, OfEccentricityMapsTheCellsAreFoundByEccentricity) {
  std::vector<Row> a;
  for (const double speed_hz : {50., 60., 70.}) {
    a.push_back(row(speed_hz, 0.1 * speed_hz, response::motion::MotionClass::synchronous, 1));
    a.back().eccentricity_m = 1e-4;
  }
  auto b = a;
  b[1].whirl_ratio *= 1 + 1e-15;  // as if computed from the eccentricity by another compiler
  const MapComparison comparison = compare(a, b);
  EXPECT_EQ(comparison.axis, "eccentricity_m");
  EXPECT_TRUE(comparison.equal());
}

TEST_F(CompareMaps, WhatIsNoMapIsAnError) {
  const auto good = table("a.csv", cells()),
             bad = table_of("b.csv", "speed_hz,whirl_ratio,eccentricity_m\n50,0.2,1\n");
  EXPECT_NE(message_of<IoError>([&] { compare_maps(good, bad, 0); }).find("b.csv: no column 'class'"),
            std::string::npos);
  auto twice = cells();
  twice.push_back(twice.front());
  EXPECT_NE(
      message_of<IoError>([&] { compare(cells(), twice); }).find("b.csv:9: this cell is in the map twice"),
      std::string::npos);
}

TEST_F(CompareMaps, TheFigureHoldsEveryCellUnderItsVerdict) {
  auto other = cells();
  other[0].order = 4;
  const std::string script = comparison_figure(compare(cells(), other), "it's a map", "svg", "out.svg");
  EXPECT_NE(script.find("set label 2 'it''s a map' at"), std::string::npos);
  EXPECT_NE(script.find("set output 'out.svg'\n"), std::string::npos);
  EXPECT_NE(comparison_figure(compare(cells(), other), "a\nsystem('b')", "svg", "|c'.svg")
                .find("set output './|c''.svg'\n"),
            std::string::npos);
  EXPECT_NE(comparison_figure(compare(cells(), other), "a\nsystem('b')", "svg", "c.svg")
                .find("set label 2 'a?system(''b'')' at"),
            std::string::npos);
  EXPECT_EQ(comparison_figure(compare(cells(), other), "a", "svg", "").find("set output"), std::string::npos);
  EXPECT_EQ(message_of<IoError>([&] { comparison_figure(compare(cells(), other), "a", "svg", "c\n.svg"); }),
            "cannot write 'c?.svg': its name has control characters");
  EXPECT_NE(script.find("$cells_0 << END\n60 0.2 55 65 0.1 "), std::string::npos);
  EXPECT_NE(script.find("$cells_3 << END\n50 0.2 45 55 "), std::string::npos);
  EXPECT_NE(script.find("title 'another class (1)'"), std::string::npos);
  EXPECT_EQ(script.find("$cells_2"), std::string::npos) << "nothing is drawn for what there is not";
  EXPECT_NE(script.find("set label 1 'Where two maps differ'"), std::string::npos);
  EXPECT_NE(script.find("set ylabel 'whirl ratio (quiet whirl / clearance)'"), std::string::npos);
}

TEST_F(CompareMaps, TheFigureIsDrawnOverTheAxesThatHaveSeveralValues) {
  MapComparison comparison;
  comparison.axis = "eccentricity_m";
  comparison.keys = {"kick.force_n", "kick.angle_deg"};
  for (const double force_n : {10, 20}) {
    for (const double speed_hz : {30, 50}) {
      ComparedCell cell;
      cell.speed_hz = speed_hz;
      cell.unbalance = 1e-4;
      cell.keys = {force_n, 90};
      comparison.cells.push_back(cell);
    }
  }
  const std::string script = comparison_figure(comparison, "a", "svg", "");
  EXPECT_NE(script.find("set label 1 'Two maps that are equal'"), std::string::npos);
  EXPECT_NE(script.find("set xlabel 'shaft speed (Hz)'\nset ylabel 'kick.force_n'\n"), std::string::npos);
  EXPECT_NE(script.find("50 20 40 60 15 25\n"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::apps
