#include "rubsweep/measurement/dataset/read_measurement.hpp"

#include <gtest/gtest.h>

#include <string>

#include "measurement/dataset/parsed.hpp"

namespace rubsweep::config::dataset {
namespace {

std::string read_whole(const std::string& text, rubsweep::dataset::Measurement& measurement) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    if (const auto value = section.require("measurement", "a map")) measurement = read_measurement(*value);
  });
}

std::string read_known(const std::string& text, diagnose::Measuring& measuring) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    if (const auto value = section.require("measurement", "a map")) read_measuring(*value, measuring);
  });
}

TEST(ReadMeasurement, OfASetHasLengthRateAndProbes) {
  rubsweep::dataset::Measurement measurement;
  ASSERT_EQ(read_whole("measurement: {turns: 40, sampling_rate_hz: 2000, probes: 1, order_2_share: 0.3}\n",
                       measurement),
            "none");
  EXPECT_EQ(measurement.turns, 40);
  EXPECT_EQ(measurement.sampling_rate_hz, 2000);
  EXPECT_EQ(measurement.probes, 1);
  EXPECT_EQ(measurement.other_lines.order_2, 0.3);
  EXPECT_EQ(measurement.other_lines.order_3, diagnose::OtherLines{}.order_3);
}

TEST(ReadMeasurement, OfADiagnosisHasDisturbancesAlone) {
  diagnose::Measuring measuring;
  ASSERT_EQ(read_known("measurement: {noise_share: 0.01, backward_1x_share: 0.05, order_2_share: 0.02,\n"
                       "  order_3_share: 0, gain_error: 0.1}\n",
                       measuring),
            "none");
  EXPECT_EQ(measuring.noise_share.low, 0.01);
  EXPECT_EQ(measuring.noise_share.high, 0.01);
  EXPECT_EQ(measuring.other_lines.backward_1x, 0.05);
  EXPECT_EQ(measuring.other_lines.order_2, 0.02);
  EXPECT_EQ(measuring.other_lines.order_3, 0);
  EXPECT_EQ(measuring.gain_error, 0.1);
  // The recording itself says these.
  for (const char* key : {"turns: 40", "probes: 1", "sampling_rate_hz: 2000"})
    EXPECT_NE(read_known("measurement: {" + std::string(key) + "}\n", measuring), "none") << key;
}

TEST(ReadMeasurement, RefusesSharesThatAreNone) {
  diagnose::Measuring measuring;
  for (const char* field :
       {"noise_share: 0", "noise_share: [0.1, 2]", "gain_error: -0.1", "order_3_share: 1.5"}) {
    const std::string said = read_known("measurement: {" + std::string(field) + "}\n", measuring);
    EXPECT_NE(said.find("study.yaml:1:"), std::string::npos) << said;
    EXPECT_NE(said.find("measurement."), std::string::npos) << said;
  }
  EXPECT_NE(read_known("measurement: {gain_eror: 0.1}\n", measuring).find("did you mean 'gain_error'?"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::dataset
