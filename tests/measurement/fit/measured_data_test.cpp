#include "rubsweep/measurement/fit/measured_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "maps/batch/message_of.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

namespace fs = std::filesystem;

class MeasuredDataTest : public testing::Test {
 protected:
  void TearDown() override { fs::remove(file_); }
  const fs::path& write(const std::string& text) {
    std::ofstream(file_) << text;
    return file_;
  }
  std::string fault(const std::string& text, double from_s = 0) {
    try {
      read_ring_down(write(text), from_s);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "none";
  }
  const TemporaryDirectory directory_;
  const fs::path file_ = directory_.path() / "data.csv";
};

TEST_F(MeasuredDataTest, RingDown) {
  std::string text = "t_s,sensor_0_m,sensor_1_m\n";
  for (int k = 0; k < 12; ++k) text += std::to_string(k) + "," + std::to_string(10 * k) + ",1\n";
  const RingDown data = read_ring_down(write(text), 2);
  EXPECT_EQ(data.t_s.size(), 10u);
  EXPECT_EQ(data.signal_m(1, 0), 30);
  EXPECT_EQ(data.signal_m(1, 1), 1);
  EXPECT_NE(fault(text, 9).find("has 3 rows"), std::string::npos);
  EXPECT_NE(fault(text + "11,3,4\n").find(":14: t_s: does not rise"), std::string::npos);
  EXPECT_NE(fault(text + "12,,4\n").find(":14: sensor_0_m: is no number"), std::string::npos);
  EXPECT_NE(fault("time,x\n").find("t_s"), std::string::npos);
}

TEST_F(MeasuredDataTest, RunUpTakesEverySecondRowOfOrderOne) {
  std::string text = "t_s,speed_hz,order,x_amplitude_m,x_phase_deg\n";
  for (int k = 0; k < 40; ++k)
    text += std::to_string(0.1 * k) + "," + std::to_string(20 + 0.4 * k) + ",1,2e-5,-90\n";
  const std::string other = text + "0,20,2,1,0\n";
  const RunUp data = read_run_up(write(other));
  EXPECT_EQ(data.t_s.size(), 20u);
  EXPECT_NEAR(data.ramp.from_hz, 20, 1e-4);
  EXPECT_NEAR(data.ramp.rate_hz_per_s, 4, 1e-4);
  EXPECT_NEAR(std::abs(data.phasor_m(3, 0) - std::complex<double>(0, -2e-5)), 0, 1e-15);
  const std::string uneven = text + "4.1,80,1,1,0\n5,90,1,1,0\n5.1,99,1,1,1\n";
  EXPECT_FALSE(read_run_up(write(uneven)).ramp.even());
  EXPECT_EQ(read_run_up(write(uneven)).ramp.knot_s, read_run_up(write(uneven)).t_s);
  EXPECT_THROW(read_run_up(write(text + "4.1,80,1,1,0\n3,90,1,1,0\n")), ConfigError);
}

TEST_F(MeasuredDataTest, InstantsOfWholeTurnsTellTheRamp) {
  // Marks rounded to 0.2 ms, as by a data logger, and the speeds between them.
  std::string text = "t_s,speed_hz,order,x_amplitude_m,x_phase_deg\n";
  const auto mark_s = [](int turn) {
    return 2e-4 * std::round((std::sqrt(24.0 * 24.0 + 8 * turn) - 24) / 4 / 2e-4);
  };
  for (int turn = 1; turn < 180; ++turn)
    text += std::to_string(mark_s(turn)) + ',' + std::to_string(2 / (mark_s(turn + 1) - mark_s(turn - 1))) +
            ",1,2e-5,-90\n";
  const RunUp data = read_run_up(write(text));
  EXPECT_TRUE(data.from_readings);
  EXPECT_NEAR(data.ramp.from_hz, 24, 5e-4);
  EXPECT_NEAR(data.ramp.rate_hz_per_s, 4, 3e-4);
}

TEST_F(MeasuredDataTest, SteadyPhasesCountFromTheSensor) {
  const Steady data =
      read_steady(write("speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,"
                        "sensor_1_phase_deg\n20,1e-5,0,2e-5,-30\n21,1e-5,0,2e-5,-30\n"),
                  {0, 90});
  EXPECT_NEAR(std::arg(data.phasor_m(0, 1)), -120 * 3.14159265358979 / 180, 1e-12);
  const RunUp run = as_run_up(data, 4, 1);
  EXPECT_EQ(run.t_s, (std::vector<double>{0, 0.25}));
  EXPECT_THROW(as_run_up(data, -4, 1), ConfigError);
}

TEST_F(MeasuredDataTest, PhasesMeanWhatIsSaid) {
  // The peak lags by 30 degrees in x and by 120 in y, because the mark passes the y probe 90 degrees later.
  using enum PhaseConvention;
  const std::string header =
      "speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,sensor_1_phase_deg\n20,1e-5,";
  const std::vector<std::pair<PhaseConvention, std::string>> tables{
      {lag, "30,2e-5,120\n"}, {mark, "-30,2e-5,240\n"}, {sensor, "-30,2e-5,-30\n"}};
  for (const auto& [convention, row] : tables) {
    const Steady data = read_steady(write(header + row), {0, 90}, convention);
    EXPECT_LT(std::abs(data.phasor_m(0, 0) - std::polar(1e-5, -3.14159265358979 / 6)), 1e-18);
    EXPECT_LT(std::abs(data.phasor_m(0, 1) - std::polar(2e-5, -3.14159265358979 * 2 / 3)), 1e-18);
    for (const auto& [other, its_row] : tables) {
      MeasuredData taken{"table", read_steady(write(header + row), {0, 90}, other), false};
      EXPECT_TRUE(has_phases_of_a_table(taken));
      take_phases_as(convention, other, {0, 90}, taken);
      EXPECT_LT((std::get<Steady>(taken.data).phasor_m - data.phasor_m).norm(), 1e-18);
    }
  }
  MeasuredData ramp{"ramp", as_run_up(read_steady(write(header + "30,2e-5,120\n"), {0, 90}), 4, 1), false};
  EXPECT_TRUE(has_phases_of_a_table(ramp));
  std::get<RunUp>(ramp.data).from_readings = true;
  EXPECT_FALSE(has_phases_of_a_table(ramp)) << "phases of rubscope are known";
}

class MeasuredDataRubTest : public testing::Test {
 protected:
  void write(const std::string& measures, const std::string& lines) {
    std::ofstream(directory_.path() / "measures.csv") << "quantity,value,uncertainty\n" << measures;
    std::ofstream(directory_.path() / "lines.csv") << "order,amplitude_m,uncertainty_m,phase_deg\n" << lines;
  }
  std::string refusal(const std::string& measures, const std::string& lines) {
    write(measures, lines);
    return message_of<ConfigError>([&] { read_rub(directory_.path()); });
  }

  const TemporaryDirectory directory_;
};

const std::string half = "speed_hz,70.5,\nperiod_turns,2,\n",
                  lines = "-0.5,1e-5,1e-8,90\n0,3e-4,1e-8,\n0.5,2e-5,1e-8,-45\n1,1e-9,1e-8,\n";

TEST_F(MeasuredDataRubTest, HasTheLinesWithAPhaseButTheGap) {
  write(half, lines);
  const RubLines rub = read_rub(directory_.path());
  EXPECT_EQ(rub.speed_hz, 70.5);
  EXPECT_EQ(rub.turns, 2);
  EXPECT_EQ(rub.order, (std::vector<double>{-0.5, 0.5}));
  EXPECT_LT(std::abs(rub.line_m(0) - std::complex<double>(0, 1e-5)), 1e-18);
  EXPECT_LT(std::abs(rub.line_m(1) - std::polar(2e-5, -3.14159265358979 / 4)), 1e-18);
}

TEST_F(MeasuredDataRubTest, RefusesWhatIsNoRubThatRepeats) {
  EXPECT_NE(refusal("speed_hz,70,\n", lines).find("measures.csv: holds no speed_hz and period_turns"),
            std::string::npos);
  for (const char* turns : {"0", "2.5", "65", "1e10", "-1"})
    EXPECT_NE(refusal("speed_hz,70,\nperiod_turns," + std::string(turns) + ",\n", lines)
                  .find("allowed: a whole number from 1 to 64"),
              std::string::npos)
        << turns;
  EXPECT_NE(refusal(half, "-0.5,1e-5,1e-8,90\n").find("lines.csv: has 1 rows"), std::string::npos);
  EXPECT_NE(refusal(half, "0.5,1e-5,1e-8,90\n1,1e-5,1e-8,0\n").find("has the lines of one probe"),
            std::string::npos);
}

using std::numbers::pi;

const Ramp even{.from_hz = 10, .rate_hz_per_s = 2};
const Ramp uneven{.from_hz = 0, .rate_hz_per_s = 0, .knot_s = {0, 1, 3}, .knot_hz = {10, 14, 12}};

TEST(MeasuredDataRamp, GoesOnBeyondItsKnots) {
  EXPECT_DOUBLE_EQ(speed_hz(even, 3), 16);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, 0.5), 12);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, 2), 13);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, -1), 6);
  EXPECT_DOUBLE_EQ(speed_hz(uneven, 4), 11);
}

TEST(MeasuredDataRampTurning, HasTheIntegralOfTheSpeedForItsAngle) {
  for (const Ramp& ramp : {even, uneven}) {
    const RampTurning turning(ramp);
    double angle = 0;
    constexpr int steps = 3000;
    for (int k = 0; k < steps; ++k) angle += turning.speed((k + 0.5) * 3.0 / steps) * 3.0 / steps;
    EXPECT_NEAR(turning.angle(3) - turning.angle(0), angle, 1e-9 * angle);
  }
}

TEST(MeasuredDataRampTurning, KnowsItsRatesAndTheSpeedsBetween) {
  const RampTurning turning(uneven);
  EXPECT_DOUBLE_EQ(turning.gain(0.5), 2 * pi * 4);
  EXPECT_DOUBLE_EQ(turning.gain(2), -2 * pi);
  EXPECT_DOUBLE_EQ(turning.most_gain(), 2 * pi * 4);
  const auto [low, high] = turning.speeds_between(0.5, 3);
  EXPECT_DOUBLE_EQ(low, 2 * pi * 12);
  EXPECT_DOUBLE_EQ(high, 2 * pi * 14);
}

}  // namespace
}  // namespace rubsweep::fit
