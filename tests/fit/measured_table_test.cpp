#include "rubsweep/fit/measured_table.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "batch/message_of.hpp"
#include "batch/temporary_directory.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::fit {
namespace {

class MeasuredTables : public testing::Test {
 protected:
  const std::filesystem::path& file(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary) << bytes;
    return path_;
  }
  const TemporaryDirectory directory_;
  const std::filesystem::path path_ = directory_.path() / "data.csv";
};

TEST_F(MeasuredTables, OfSomebodyAreReadByNamesAndUnits) {
  MeasuredTable table(file("Test rig 3;;\nSpeed [rpm];sensor_0_amplitude [\xB5m];sensor_0 phase [rad]\n"
                           "1200;2,5;3,141592653589793\n2400;3;0\n"),
                      "speed_hz");
  const std::size_t speed = table.column("speed_hz"), amplitude = table.column("sensor_0_amplitude_m"),
                    phase = table.column("sensor_0_phase_deg");
  ASSERT_TRUE(table.next());
  EXPECT_DOUBLE_EQ(table.number(speed), 20);
  EXPECT_DOUBLE_EQ(table.number(amplitude), 2.5e-6);
  EXPECT_DOUBLE_EQ(table.number(phase), 180);
  EXPECT_EQ(table.place().line, 3u);
  ASSERT_TRUE(table.next());
  EXPECT_DOUBLE_EQ(table.number(speed), 40);
  EXPECT_FALSE(table.next());
  EXPECT_THROW(table.column("t_s"), IoError);
}

TEST_F(MeasuredTables, OfTheProgramsStayStrict) {
  MeasuredTable table(file("# of rubtrace\nt_s,sensor_0_m\n0,1e-6\n0.1,x\n"), "t_s");
  ASSERT_TRUE(table.next());
  EXPECT_EQ(table.number(table.column("sensor_0_m")), 1e-6);
  ASSERT_TRUE(table.next());
  EXPECT_THROW(table.number(1), IoError);
}

TEST_F(MeasuredTables, WithoutTheColumnOrWithBadNumbersAreRefused) {
  EXPECT_THROW(MeasuredTable(file("a;b\n1;2\n3;4\n"), "t_s"), IoError);
  EXPECT_THROW(MeasuredTable(file("Time [h];b\n1;2\n3;4\n"), "t_s"), IoError);
  EXPECT_THROW(MeasuredTable(directory_.path() / "none.csv", "t_s"), IoError);
  const std::string message = ::message_of<ConfigError>(
      [&] { MeasuredTable(file("Time [ms];sensor_0 [um]\n0;1\n1;2\n2;3,x\n"), "t_s"); });
  EXPECT_EQ(message.substr(message.find("data.csv")),
            "data.csv:4:3: '3,x' is no number, allowed: a number with a decimal comma");
}

}  // namespace
}  // namespace rubsweep::fit
