#include "rubsweep/maps/report/explain_tables.hpp"

#include <gtest/gtest.h>

#include "core/scene/table_machine.hpp"

namespace rubsweep::report {
namespace {

TEST(ExplainTables, ShowsTheCoefficientsAtTheSpeedsOfTheSweep) {
  const std::string text = explain_tables(scene::table_machine(), {80, 40, 55});
  EXPECT_NE(text.find("support 1 at 0.4 m: table of 5 speeds from 20 to 120 Hz (1200 to 7200 rpm)"), std::string::npos)
      << text;
  EXPECT_NE(text.find("at 40 Hz (2400 rpm): kxx 26000 kxy 900 kyx -800 kyy 25000 cxx 70 cxy 2 cyx 2 cyy 70\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("at 80 Hz (4800 rpm): kxx 33000"), std::string::npos) << text;
  EXPECT_EQ(text.find("mxx"), std::string::npos) << text;
  EXPECT_EQ(explain_tables(scene::light_shaft_machine(), {40}), "");
}

TEST(ExplainTablesDescribeSparse, NamesThoseOfFewerThanFourSpeeds) {
  model::Machine machine = scene::table_machine();
  EXPECT_EQ(describe_sparse_tables(machine), "");
  model::SupportTable& table = *model::kit_of(machine)->supports[1].table;
  table.speed_hz.resize(3);
  for (auto& column : table.columns) column.resize(3);
  EXPECT_TRUE(describe_sparse_tables(machine).starts_with("rotor.supports.1.table: has 3 speeds"));
}

}  // namespace
}  // namespace rubsweep::report
