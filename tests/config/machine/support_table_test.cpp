#include "rubsweep/config/machine/support_table.hpp"

#include <filesystem>

#include "batch/temporary_directory.hpp"
#include "config/support.hpp"
#include "rubsweep/config/print_config.hpp"

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

TEST(SupportTable, ANumberOfItCanBeSetAndSwept) {
  const RunConfig set = read_run_config_text(test_file("support_table.yaml"), "test.yaml",
                                             {"rotor.supports.1.table.kyy.2=4.0e4"});
  EXPECT_EQ(tabled(set).table->columns[3][2], 4e4);
}

}  // namespace
}  // namespace rubsweep::config::machine
