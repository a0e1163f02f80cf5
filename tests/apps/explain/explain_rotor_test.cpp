#include "explain/explain_rotor.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/scene/table_machine.hpp"
#include "core/structure/hand_matrices.hpp"

namespace rubsweep::apps {
using report::says;

namespace {

std::string explained(const model::ShaftMatrices& matrices) {
  model::RotorKit kit;
  kit.matrices = std::make_shared<model::ShaftMatrices>(matrices);
  return explain_matrices(kit);
}

TEST(ExplainRotorExplainMatrices, SaysWhatIsSymmetricAndWhatIsNot) {
  EXPECT_EQ(explained(structure::disc_and_bracket()),
            "rotor: matrices of 4 degrees of freedom at 1 nodes along 0.5 m and 1 bodies, 2 kg; 0 supports "
            "beside them\n"
            "  stiffness: not symmetric, most between y of node disc and x of node disc, by 7000; such a "
            "rotor can whirl "
            "up by itself\n"
            "  damping: symmetric\n"
            "  gyroscopic: none\n");
  model::ShaftMatrices book = structure::book_rotor();
  book.stiffness(0, 4) *= 1 + 1e-13;
  const std::string text = explained(book);
  EXPECT_NE(
      text.find("  stiffness: symmetric\n  damping: none\n  gyroscopic: skew-symmetric, times the speed\n"),
      std::string::npos)
      << text;
  book.mass.setZero();
  EXPECT_NE(explained(book).find("but for 28 degrees of freedom without any"), std::string::npos);
}

TEST(ExplainRotor, NamesWhatHasAName) {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  const auto text = [&] { return explain_rotor(scene::prepare_machine(machine), false); };
  EXPECT_EQ(text().find("discs: "), std::string::npos);
  kit.discs[0].name = "Impeller";
  kit.supports[1].name = "Free end";
  kit.sensors = {{.position_m = 0.1, .name = "DE x"}, {.position_m = 0.1, .angle_deg = 90}};
  EXPECT_NE(text().find("  discs: 0 (Impeller) at 0.2 m\n  supports: 1 (Free end) at 0.4 m\n"
                        "  sensors: 0 (DE x) at 0.1 m\n"),
            std::string::npos)
      << text();
}

TEST(ExplainRotorExplainTables, ShowsTheCoefficientsAtTheSpeedsOfTheSweep) {
  const std::string text = explain_tables(scene::table_machine(), {80, 40, 55});
  EXPECT_NE(text.find("support 1 at 0.4 m: table of 5 speeds from 20 to 120 Hz (1200 to 7200 rpm)"),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find("at 40 Hz (2400 rpm): kxx 26000 kxy 900 kyx -800 kyy 25000 cxx 70 cxy 2 cyx 2 cyy 70\n"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("at 80 Hz (4800 rpm): kxx 33000"), std::string::npos) << text;
  EXPECT_EQ(text.find("mxx"), std::string::npos) << text;
  EXPECT_EQ(explain_tables(scene::light_shaft_machine(), {40}), "");
}

TEST(ExplainRotorExplainTablesDescribeSparse, NamesThoseOfFewerThanFourSpeeds) {
  model::Machine machine = scene::table_machine();
  EXPECT_EQ(describe_sparse_tables(machine), "");
  model::SupportTable& table = *model::kit_of(machine)->supports[1].table;
  table.speed_hz.resize(3);
  for (auto& column : table.columns) column.resize(3);
  EXPECT_TRUE(describe_sparse_tables(machine).starts_with("rotor.supports.1.table: has 3 speeds"));
}

}  // namespace
}  // namespace rubsweep::apps
