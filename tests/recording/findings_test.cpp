#include "rubsweep/recording/findings.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::recording {
namespace {

std::vector<std::string> of_readings(const std::vector<double>& readings) {
  const std::vector<std::size_t> line(readings.size(), 1);
  std::vector<std::string> findings;
  add_findings(readings, "x", line, findings);
  return findings;
}

TEST(Findings, ClippedIsNotTheFlatTopOfACoarseConverter) {
  std::vector<double> coarse, clipped, both;
  for (int k = 0; k < 4000; ++k) {
    const double value = std::sin(0.005 * k);
    coarse.push_back(std::round(200 * value) / 200);
    clipped.push_back(std::fmin(value, 0.5));
    both.push_back(std::fmin(std::fmax(std::round(200 * std::sin(0.3 * k)) / 200, -0.1), 0.1));
  }
  EXPECT_TRUE(of_readings(coarse).empty());
  EXPECT_EQ(of_readings(clipped), std::vector<std::string>{"'x' is clipped above"});
  EXPECT_EQ(of_readings(both).size(), 0u + 1u);
}

TEST(Findings, AnUnsteadySpeedAndFewReadings) {
  std::vector<std::string> findings;
  add_speed_findings(std::vector<double>{0, 0.1, 0.2, 0.3}, 1000, findings);
  EXPECT_TRUE(findings.empty());
  add_speed_findings(std::vector<double>{0, 0.1, 0.2, 0.325}, 1000, findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0], "the speed is unsteady: at 0.2 s it goes from 10 to 8 Hz within a turn");
  findings.clear();
  add_speed_findings(std::vector<double>{0, 0.1, 0.2}, 150, findings);
  EXPECT_EQ(findings,
            std::vector<std::string>{"15 readings a turn: motion above 7.5X is folded to other orders"});
}

}  // namespace
}  // namespace rubsweep::recording
