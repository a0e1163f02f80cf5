#include "rubsweep/measurement/recording/labview_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "measurement/recording/instrument_files.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/recording/delimited_text.hpp"

namespace rubsweep::recording {
namespace {

using files::labview_head, files::labview_segment;

const auto labview_signals = files::signals(40);

std::string two_signals(std::size_t k) {
  return fmt::format("\t{:.9f}\t{:.9f}", labview_signals.x[k], labview_signals.y[k]);
}
std::string with_times(std::size_t k) {
  return fmt::format("{:.4f}{}", 0.001 * static_cast<double>(k), two_signals(k));
}

void expect_signals(const Channels& table, std::size_t rows) {
  ASSERT_EQ(table.channels.size(), 3u);
  ASSERT_EQ(table.rows(), rows);
  EXPECT_EQ(table.channels[0].name, "X_Value");
  EXPECT_EQ(table.channels[0].unit, "s");
  EXPECT_EQ(table.channels[1].unit, "um");
  EXPECT_EQ(table.channels[2].unit, "Volts");
  for (std::size_t k = 0; k < rows; ++k) {
    EXPECT_NEAR(table.channels[0].values[k], 0.001 * static_cast<double>(k), 1e-9);
    EXPECT_NEAR(table.channels[1].values[k], labview_signals.x[k % 40], 1e-8);
    EXPECT_NEAR(table.channels[2].values[k], labview_signals.y[k % 40], 1e-8);
  }
}

std::string labview_fault(const std::string& text) {
  try {
    read_delimited_text(text, "f.lvm");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

constexpr std::string_view labview_names = "X_Value\tX\tKP\tComment";

TEST(LabviewText, ReadsOneColumnOfTimesOrNone) {
  const Channels none = read_delimited_text(
      labview_head("No") + labview_segment(40, "10:15:30.1", labview_names, two_signals), "f");
  expect_signals(none, 40);
  EXPECT_EQ(none.sampling_rate_hz, 1000);
  expect_signals(read_delimited_text(
                     labview_head("One") + labview_segment(40, "10:15:30.1", labview_names, with_times), "f"),
                 40);
}

TEST(LabviewText, JoinsTimesThatAreTheSame) {
  const auto row = [](std::size_t k) {
    return fmt::format("{0:.4f}\t{1:.9f}\t{0:.4f}\t{2:.9f}", 0.001 * static_cast<double>(k),
                       labview_signals.x[k], labview_signals.y[k]);
  };
  const std::string segment =
      "Channels\t2\t\t\t\t\nY_Unit_Label\tum\t\tVolts\t\t\nDelta_X\t0.001\t\t0.001\t\t\n***End_of_Header***"
      "\t\n"
      "X_Value\tX\tX_Value\tKP\tComment\n";
  std::string rows, other;
  for (std::size_t k = 0; k < 40; ++k) rows += row(k) + '\n';
  for (std::size_t k = 0; k < 40; ++k)
    other += fmt::format("{:.4f}\t1\t{:.4f}\t2\n", 0.001 * static_cast<double>(k),
                         0.0012 * static_cast<double>(k));
  const Channels table = read_delimited_text(labview_head("Multi") + segment + rows, "f");
  expect_signals(table, 40);
  EXPECT_EQ(table.channels[2].number, 4u);
  EXPECT_NE(labview_fault(labview_head("Multi") + segment + other).find("has other times for one signal"),
            std::string::npos);
}

TEST(LabviewText, BracketsOfANameAreNoUnitWhereTheHeadHasAnother) {
  const Channels table = read_delimited_text(
      labview_head("No") +
          labview_segment(3, "10:15:30", "X_Value\tX (um)\tResponse (Trigger)\tComment", two_signals),
      "f");
  EXPECT_EQ(table.channels[1].name, "X");
  EXPECT_EQ(table.channels[1].unit, "um");
  EXPECT_EQ(table.channels[2].name, "Response (Trigger)");
  EXPECT_EQ(table.channels[2].unit, "Volts");
}

/// The first signal ends before the second, so that its times end with empty cells.
TEST(LabviewText, KeepsItsRateWhereASignalEndsEarly) {
  std::string text = labview_head("Multi") +
                     "Channels\t2\t\t\t\t\nDelta_X\t0.5\t\t0.5\t\t\n***End_of_Header***\t\n"
                     "X_Value\tX\tX_Value\tKP\tComment\n0\t1\t0\t2\n0.5\t2\t0.5\t3\n1\t3\t1\t4\n\t\t1.5\t5\n";
  const Channels table = read_delimited_text(text, "f");
  EXPECT_EQ(table.sampling_rate_hz, 2);
  EXPECT_EQ(table.rows(), 3u);
}

TEST(LabviewText, HasNoRateWhereTheTimesDoNotKeepToIt) {
  const auto row = [](std::size_t k) { return fmt::format("{}\t1\t2", k * k); };
  const Channels table =
      read_delimited_text(labview_head("One") + labview_segment(4, "10:15:30", labview_names, row), "f");
  EXPECT_FALSE(table.sampling_rate_hz);
  EXPECT_EQ(table.channels[0].values[3], 9);
}

TEST(LabviewText, SegmentsFollowEachOtherByTheirInstants) {
  const std::string first =
      labview_head("No") + labview_segment(40, "10:15:30.100", labview_names, two_signals);
  expect_signals(
      read_delimited_text(first + labview_segment(40, "10:15:30.140", labview_names, two_signals), "f"), 80);
  const Channels gap =
      read_delimited_text(first + labview_segment(40, "10:15:31.100", labview_names, two_signals), "f");
  EXPECT_NEAR(gap.channels[0].values[40], 1, 1e-9);
  EXPECT_FALSE(gap.sampling_rate_hz);
  EXPECT_EQ(gap.line[40], gap.line[0] + 51);
}

TEST(LabviewText, AnotherStepForAnotherSignalIsRefusedAtItsPlace) {
  std::string text = labview_head("No");
  for (const char* time : {"10:15:30.100", "10:15:31"})
    text += labview_segment(40, time, labview_names, two_signals);
  const std::size_t step = text.rfind("\nDelta_X\t") + 1;
  text.insert(text.find('\n', step), "\t0.002");
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(step), '\n') + 1;
  EXPECT_TRUE(labview_fault(text).starts_with(fmt::format("f.lvm:{}:", line))) << labview_fault(text);
  EXPECT_NE(labview_fault(text).find("has another Delta_X for another signal"), std::string::npos);
}

TEST(LabviewText, RefusesSegmentsThatDoNotFollow) {
  const std::string first =
      labview_head("No") + labview_segment(40, "10:15:30.100", labview_names, two_signals);
  EXPECT_NE(labview_fault(first + labview_segment(40, "10:15:30.100", labview_names, two_signals))
                .find("whose times do not follow"),
            std::string::npos);
  EXPECT_NE(labview_fault(first + labview_segment(40, "10:15:40", "X_Value\tZ\tKP\tComment", two_signals))
                .find("with other signals"),
            std::string::npos);
  EXPECT_NE(labview_fault(first + "X_Value\tX\tKP\n\t1\t2\n").find("without its head"), std::string::npos);
  std::string broken = first + labview_segment(40, "10:15:40", labview_names, two_signals);
  broken.insert(broken.rfind("\n\t"), "\t1\t2\t3\t4");
  EXPECT_NE(labview_fault(broken).find("has another number of cells"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::recording
