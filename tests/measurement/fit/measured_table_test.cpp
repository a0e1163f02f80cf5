#include "rubsweep/measurement/fit/measured_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

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

using std::numbers::pi;

/// Instants of every second turn of a shaft, found by bisection and rounded to the readings of a logger, and
/// the speeds computed from neighbouring instants.
struct Marks {
  std::vector<double> t_s, speed_hz;
};
Marks marks_of(const std::function<double(double)>& turns, int rows, double reading_s) {
  Marks marks;
  double low = 0;
  for (int k = 0; k < rows; ++k) {
    double high = low + 10;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (turns(middle) < 2 * k ? low : high) = middle;
    }
    marks.t_s.push_back(reading_s > 0 ? reading_s * std::round(low / reading_s) : low);
  }
  for (std::size_t k = 0; k < marks.t_s.size(); ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, marks.t_s.size() - 1);
    marks.speed_hz.push_back(2 * static_cast<double>(after - before) /
                             (marks.t_s[after] - marks.t_s[before]));
  }
  return marks;
}

/// Turns of a ramp from 17 Hz, whose rate of 2 Hz/s varies slowly by `share` as a sine.
double uneven_turns(double t, double share, double wave) {
  return 17 * t + t * t - 2 * share / wave * (std::sin(wave * t) / wave - t);
}
double uneven_speed(double t, double share, double wave) {
  return 17 + 2 * t + 2 * share / wave * (1 - std::cos(wave * t));
}

TEST(MeasuredTable, UnevennessOfAnySizeIsFollowed) {
  for (const double share : {0.01, 0.03, 0.05, 0.1, 0.3}) {
    for (const double wave : {0.25, 0.5, 1.0}) {
      const Marks marks = marks_of([&](double t) { return uneven_turns(t, share, wave); }, 240, 1.0 / 5000);
      const Ramp ramp = measured_ramp(marks.t_s, marks.speed_hz);
      EXPECT_FALSE(ramp.even()) << share << ' ' << wave;
      double square = 0;
      for (const double t : marks.t_s)
        square += std::pow(speed_hz(ramp, t) / uneven_speed(t, share, wave) - 1, 2);
      EXPECT_LT(std::sqrt(square / static_cast<double>(marks.t_s.size())), 2.5e-4) << share << ' ' << wave;
    }
  }
}

TEST(MeasuredTable, AnEvenOneStaysEvenWhateverTheReadings) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const double from = std::uniform_real_distribution<double>(8, 40)(random);
    const double rate = std::uniform_real_distribution<double>(0.5, 6)(random);
    const double reading_s = 1 / std::uniform_real_distribution<double>(4000, 20000)(random);
    const Marks marks = marks_of([&](double t) { return from * t + rate * t * t / 2; }, 150, reading_s);
    const Ramp ramp = measured_ramp(marks.t_s, marks.speed_hz);
    ASSERT_TRUE(ramp.even()) << from << ' ' << rate << ' ' << reading_s;
    EXPECT_NEAR(ramp.rate_hz_per_s / rate, 1, 2e-3);
    EXPECT_NEAR(ramp.from_hz / from, 1, 1e-3);
  }
}

TEST(MeasuredTable, SpeedsAloneTellItWhereRowsAreNoWholeTurnsApart) {
  Marks marks;
  for (int k = 0; k < 200; ++k) {
    marks.t_s.push_back(0.0371 * k);
    marks.speed_hz.push_back(uneven_speed(marks.t_s.back(), 0.05, 0.8));
  }
  const Ramp ramp = measured_ramp(marks.t_s, marks.speed_hz);
  EXPECT_FALSE(ramp.even());
  EXPECT_NEAR(speed_hz(ramp, 3.3), uneven_speed(3.3, 0.05, 0.8), 1e-4);
  for (std::size_t k = 0; k < 200; ++k) marks.speed_hz[k] = 20 + 3 * marks.t_s[k];
  const Ramp even = measured_ramp(marks.t_s, marks.speed_hz);
  EXPECT_TRUE(even.even());
  EXPECT_NEAR(even.rate_hz_per_s, 3, 1e-9);
}

TEST(MeasuredTable, StepsAreFollowedFromRowToRow) {
  Marks marks;
  for (int k = 0; k < 60; ++k) {
    marks.t_s.push_back(0.05 * k);
    marks.speed_hz.push_back(k < 30 ? 20 : 40);
  }
  const Ramp ramp = measured_ramp(marks.t_s, marks.speed_hz);
  EXPECT_EQ(ramp.knot_hz, marks.speed_hz);
}

}  // namespace
}  // namespace rubsweep::fit
