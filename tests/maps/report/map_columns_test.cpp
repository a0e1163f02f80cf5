#include "rubsweep/maps/report/map_columns.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/study_columns.hpp"

namespace rubsweep::report {
namespace {

TEST(MapColumns, NamesAreDistinctAndSayTheUnit) {
  std::set<std::string_view> names;
  for (const MapColumn& column : map_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_EQ(column.name.ends_with("_m"), column.unit == "m") << column.name;
    EXPECT_EQ(column.name.ends_with("_n"), column.unit == "N") << column.name;
    EXPECT_EQ(column.name.ends_with("_hz"), column.unit == "Hz") << column.name;
    EXPECT_FALSE(column.description.empty()) << column.name;
  }
}

TEST(MapColumns, PlacesAreThoseOfTheHeader) {
  const std::string header = map_header();
  EXPECT_TRUE(header.starts_with(map_columns().front().name));
  for (std::size_t i = 0; i < map_columns().size(); ++i) EXPECT_EQ(place_of_column(map_columns()[i].name), i);
  EXPECT_THROW(place_of_column("speed"), SolverError);
}

TEST(MapColumns, OfEachComparison) {
  EXPECT_EQ(columns_compared(Comparison::key), "speed_hz, whirl_ratio");
  EXPECT_EQ(columns_compared(Comparison::label), "class, order");
  EXPECT_EQ(columns_compared(Comparison::text), "orbit, whirl");
}

/// Numbers that depend on how long one looked, or on how well a proof succeeded, are no property of the cell.
TEST(MapColumns, NumbersOfTheWayToTheVerdictAreNotCompared) {
  for (const char* name : {"proof", "floquet_modulus", "lyapunov_per_revolution", "last_contact_revolution",
                           "revolutions", "status", "start"})
    EXPECT_EQ(map_columns()[place_of_column(name)].comparison, Comparison::ignored) << name;
}

std::string document(const std::string& name) {
  std::ifstream file(RUBSWEEP_TEST_DATA "/../../../docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A column that the reference does not explain, or a class that the guide does not.
TEST(MapColumns, AndClassesStandInTheDocumentsAndInTheHelp) {
  const std::string columns_page = document("reference/columns.md"),
                    guide = document("guide/reading-a-map.md");
  const std::string help = describe_map_columns();
  const auto expect_both = [&](const std::string& page, std::string_view word) {
    EXPECT_NE(page.find(fmt::format("`{}`", word)), std::string::npos) << word;
    EXPECT_NE(help.find(fmt::format("\n  {} ", word)), std::string::npos) << word;
  };
  for (const MapColumn& column : map_columns()) expect_both(columns_page, column.name);
  for (const auto& columns : {torsion_columns(), hertz_columns(), threshold_columns(), basin_columns(),
                              refinement_columns(), robustness_columns()}) {
    for (const StudyColumn& column : columns) expect_both(columns_page, column.name);
  }
  for (const auto motion_class : response::motion::motion_classes)
    expect_both(guide, to_string(motion_class));
}

}  // namespace
}  // namespace rubsweep::report
