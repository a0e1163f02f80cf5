#include "rubsweep/measurement/dataset/read_measurement.hpp"

#include <gtest/gtest.h>

#include <string>

#include "measurement/dataset/parsed.hpp"

namespace rubsweep::config::dataset {
namespace {

std::string read(const std::string& text, bool logarithmic, diagnose::Spread& spread) {
  return problems(text, [&](const yaml::Value& root) {
    yaml::Section section(root);
    read_spread(section, "k", model::Range{.low = 0, .high = 10}, logarithmic, spread);
    section.refuse_unknown_keys();
  });
}

TEST(ReadMeasurementSpreadField, NumberIsKnown) {
  diagnose::Spread spread;
  EXPECT_EQ(read("k: 3\n", true, spread), "none");
  EXPECT_EQ(spread.low, 3);
  EXPECT_EQ(spread.high, 3);
}

TEST(ReadMeasurementSpreadField, ListOfTwoIsAnInterval) {
  diagnose::Spread spread;
  EXPECT_EQ(read("k: [1, 4]\n", true, spread), "none");
  EXPECT_DOUBLE_EQ(value_at(spread, 0.5), 2);
  EXPECT_EQ(read("k: [1, 4]\n", false, spread), "none");
  EXPECT_DOUBLE_EQ(value_at(spread, 0.5), 2.5);
}

TEST(ReadMeasurementSpreadField, MissingKeyLeavesTheUsualInterval) {
  diagnose::Spread spread{5, 6, false};
  EXPECT_EQ(read("{}\n", false, spread), "none");
  EXPECT_EQ(spread.low, 5);
  EXPECT_EQ(spread.high, 6);
}

TEST(ReadMeasurementSpreadField, RefusesWhatIsNoIntervalWithItsPlace) {
  diagnose::Spread spread{5, 6, false};
  EXPECT_EQ(read("k: [4, 1]\n", false, spread),
            "study.yaml:1:4: k: begins above its end, allowed: [low, high]");
  EXPECT_NE(read("k: [0, 1]\n", true, spread).find("study.yaml:1:4: k: begins at 0"), std::string::npos);
  EXPECT_NE(read("k: [1, 11]\n", false, spread).find("study.yaml:1:4: k: goes out of range"),
            std::string::npos);
  EXPECT_NE(read("k: 11\n", false, spread).find("study.yaml:1:4: k: "), std::string::npos);
  EXPECT_NE(read("k: [1, 2, 3]\n", false, spread).find("study.yaml:1:4: k: "), std::string::npos);
  EXPECT_NE(read("k: [1, x]\n", false, spread), "none");
  EXPECT_EQ(spread.low, 5);
  EXPECT_EQ(spread.high, 6);
}

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
