#include "rubsweep/maps/table/layout.hpp"

#include <gtest/gtest.h>

namespace rubsweep::table {
namespace {

/// Names and units of the numeric columns, such as "t/s X/um".
std::string names_of(std::string_view text) {
  std::string names;
  const std::vector<Column> columns = layout_of(text).columns;
  for (const Column& column : columns) {
    if (column.is_text) continue;
    names += (&column == &columns.front() ? "" : " ") + column.heading.name;
    if (!column.heading.unit.empty()) names += "/" + column.heading.unit;
  }
  return names;
}

TEST(Layout, NamesAreWhatTheirCellsAre) {
  EXPECT_EQ(names_of("t (s),X (um)\n0,1\n1,2\n"), "t/s X/um");
  // A header before the table has as many cells as the table.
  EXPECT_EQ(names_of("Date,2026-01-02\nRate,1000\n\nt (s),X (um)\n0,1\n1,2\n2,3\n"), "t/s X/um");
  EXPECT_EQ(names_of("Project;lab;;\nGain;8;;\nt;X;Y;KP\ns;um;um;V\n0;1;2;3\n1;2;3;4\n"),
            "t/s X/um Y/um KP/V");
  EXPECT_EQ(names_of("Time\tX\ns\tum\nRate=1000Hz\tRate=1000Hz\n0\t1\n1\t2\n"), "Time/s X/um");
  EXPECT_EQ(names_of("# written by a program\n# t x\n# t\tx\n0\t1\n1\t2\n"), "t x");
  EXPECT_EQ(names_of("m,s\n0,1\n1,2\n"), "m s");
  // There is one name fewer than numbers, so the names could belong to other columns and are ignored.
  EXPECT_EQ(names_of("X,Y\n0,1,2\n1,2,3\n"), "  ");
  EXPECT_EQ(names_of(",X,Y\n0,1,2\n1,2,3\n"), " X Y");
  EXPECT_EQ(names_of("t,X,X\n0,1,2\n1,2,3\n"), "t X X");
  EXPECT_EQ(names_of("Mode,Detail,Mode,Detail\n0,1,2,3\n1,2,3,4\n"), "   ");
  EXPECT_EQ(names_of("Volt,Volt\n0,1\n1,2\n"), "/Volt /Volt");
}

TEST(Layout, BlanksPartCellsWhereMostLinesHaveNumbersByThem) {
  EXPECT_EQ(names_of("a run of today\n  t [s]   X [um]\n 0.0   1.5\n 1.0  -2.5\n 2.0 3\n"), "t/s X/um");
  EXPECT_EQ(names_of("# t x\n0 1\n1 2\n"), "t x");
  EXPECT_EQ(layout_of("Run 7 of 9\nX in um\n1.5\n2.5\n3.5\n").separator, '\t');
}

TEST(Layout, ANameMayStandAboveItsUnit) {
  const auto known = [](const Heading& heading) { return heading.name != "stiffness"; };
  const Layout two = layout_of("speed,stiffness\n[rpm],kxx [N/m]\n1,2\n", known);
  EXPECT_EQ(two.columns[0].heading.name, "speed");
  EXPECT_EQ(two.columns[0].heading.unit, "rpm");
  EXPECT_EQ(two.columns[1].heading.name, "kxx");
  EXPECT_EQ(two.numbers_line, 3u);
}

TEST(Layout, ColumnsOfWordsAreNoNumbers) {
  const Layout some = layout_of("t,x,Comment\n0,1,begin\n1,2\n2,3\n");
  ASSERT_EQ(some.columns.size(), 3u);
  EXPECT_TRUE(some.columns[2].is_text);
  EXPECT_EQ(some.fewest_cells, 2u);
  const Layout between = layout_of("t,state,x\n0,OK,1\n1,OVL,2\n");
  EXPECT_TRUE(between.columns[1].is_text);
  EXPECT_EQ(between.columns[1].text_line, 2u);
  EXPECT_EQ(between.fewest_cells, 3u);
}

TEST(Layout, NumbersBeginWhereRowsAreMadeAsTheOthers) {
  const Layout layout = layout_of("Channels,2\nRate,100\nGain,3\nGain,4\nGain,5\nGain,6\nt,x\n0.5,1\n1,2\n");
  EXPECT_EQ(layout.numbers_line, 8u);
  EXPECT_EQ(layout.names_line, 7u);
  EXPECT_EQ(layout_of("a;b\n1,5;2,5\n3;4\n").separator, ';');
  EXPECT_EQ(layout_of("a,b\n\"1,5\",\"2,5\"\n\"3\",\"4\"\n").columns.size(), 2u);
}

TEST(Layout, OfKnownNamesMayHoldTextAlone) {
  const auto known = [](const Heading& heading) { return heading.name == "node" || heading.name == "speed"; };
  const Layout words = layout_of("a title; of it\nnode;direction\nDE;x\n", known);
  EXPECT_EQ(words.names_line, 2u);
  EXPECT_EQ(words.numbers_line, 3u);
  EXPECT_EQ(words.columns[1].heading.name, "direction");
  EXPECT_EQ(words.columns[1].column, 6u);
  const Layout units = layout_of("speed\tkxx\nrpm\tN/m\n1\t2\n", known);
  EXPECT_EQ(units.columns[1].heading.unit, "N/m");
  EXPECT_EQ(units.numbers_line, 3u);
  EXPECT_THROW(layout_of("1,2\n3,4\n", known), Fault);
}

}  // namespace
}  // namespace rubsweep::table
