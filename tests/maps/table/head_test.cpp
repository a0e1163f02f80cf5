#include "rubsweep/maps/table/head.hpp"

#include <gtest/gtest.h>

namespace rubsweep::table {
namespace {

double rate_of(std::string_view text) { return sampling_rate_in(text, layout_of(text)).value_or(0); }

TEST(Head, SaysTheSamplingRateInManyWays) {
  EXPECT_EQ(rate_of("t\tx\n1000 Hz\t1000 Hz\n0\t1\n1\t2\n"), 1000);
  EXPECT_EQ(rate_of("SampleRate=2.5kHz;\nt;x\n0;1\n1;2\n"), 2500);
  EXPECT_EQ(rate_of("Sample rate:\t200\nt\tx\n0\t1\n1\t2\n"), 200);
  EXPECT_EQ(rate_of("Sampling Period,2.0E-03,Sampling Period,2.0E-03\nWaveform Data,,,\n0,1,0,2\n1,2,1,3\n"),
            500);
  EXPECT_EQ(rate_of("Sample Interval,Analog:4.0E-3\nTime,CH1\n0,1\n1,2\n2,3\n"), 250);
  EXPECT_EQ(rate_of("X,CH1,Start,Increment\nSequence,Volt,0,1.0e-3\n0,1,,\n1,2,,\n2,3,,\n"), 1000);
  EXPECT_EQ(rate_of("Abtastrate [Hz];100,5\nx;y\n0;1\n1;2\n"), 100.5);
}

TEST(Head, DoubtfulRatesAreNone) {
  EXPECT_EQ(rate_of("Rate,1000\nSample Rate,500\nt,x\n0,1\n1,2\n2,3\n"), 0);
  EXPECT_EQ(rate_of("Rate,fast\nDelta_X,-1\nt,x\n0,1\n1,2\n2,3\n"), 0);
  EXPECT_EQ(rate_of("Rate,0\nt,x\n0,1\n1,2\n2,3\n"), 0);
  EXPECT_EQ(rate_of("Low pass filter: 5000 Hz\nt\tx\n0\t1\n1\t2\n"), 0);
  EXPECT_EQ(rate_of("Sample rate:\t25,600 Hz\nt\tx\n0\t1\n1\t2\n"), 0);
  EXPECT_EQ(rate_of("Sample rate: 25600 Hz\nShaft speed: 50 Hz\nt\tx\n0\t1\n1\t2\n"), 25600);
}

TEST(Head, MayStandBesideTheFirstRows) {
  std::string text =
      "Sample Interval,1e-3,,-0.2,1.5,\nSource,CH1,,-0.199,1.6,\nVertical Units,V,,-0.198,1.7,\n"
      "Horizontal Units,s,,-0.197,1.8,\n";
  for (int k = 4; k < 20; ++k) text += ",,,-0.1" + std::to_string(k) + ",2,\n";
  const Layout layout = layout_of(text);
  ASSERT_TRUE(layout.head_beside);
  EXPECT_TRUE(layout.columns[1].is_text);
  EXPECT_EQ(layout.columns[3].heading.name, "time");
  EXPECT_EQ(layout.columns[3].heading.unit, "s");
  EXPECT_EQ(layout.columns[4].heading.name, "CH1");
  EXPECT_EQ(layout.columns[4].heading.unit, "V");
  EXPECT_EQ(layout.numbers_line, 1u);
  EXPECT_EQ(sampling_rate_in(text, layout), 1000);
}

}  // namespace
}  // namespace rubsweep::table
