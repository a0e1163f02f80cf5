#include "rubsweep/core/model/length_text.hpp"

#include <gtest/gtest.h>

namespace rubsweep::model {
namespace {

TEST(LengthText, IsInTheUsualUnitUnlessAnotherIsAskedFor) {
  EXPECT_EQ(length_text(25.4e-6, {}, LengthUnit::m), "2.54e-05 m");
  EXPECT_EQ(length_text(25.4e-6, {}, LengthUnit::um), "25.4 um");
  EXPECT_EQ(length_text(25.4e-6, {LengthUnit::mil}, LengthUnit::m), "1 mil");
  EXPECT_EQ(length_text(25.4e-6, {LengthUnit::mm}, LengthUnit::um), "0.0254 mm");
  EXPECT_EQ(length_text(0.0006573489, {LengthUnit::um}, LengthUnit::m), "657.3 um");
  EXPECT_EQ(length_text(0.0006573489, {LengthUnit::um}, LengthUnit::m, 2), "6.6e+02 um");
}

TEST(LengthText, DoublesAmplitudesAloneFromPeakToPeak) {
  const ShownLengths shown{LengthUnit::mil, true};
  EXPECT_EQ(amplitude_text(25.4e-6, shown, LengthUnit::m), "2 mil peak to peak");
  EXPECT_EQ(length_text(25.4e-6, shown, LengthUnit::m), "1 mil");
  EXPECT_EQ(amplitude_text(25.4e-6, {}, LengthUnit::m), "2.54e-05 m");
}

TEST(LengthText, KnowsTheWordsOfTheCommandLine) {
  EXPECT_EQ(length_unit_of("mm"), LengthUnit::mm);
  EXPECT_EQ(length_unit_of("um"), LengthUnit::um);
  EXPECT_EQ(length_unit_of("mil"), LengthUnit::mil);
  EXPECT_EQ(word_of(LengthUnit::mil), "mil");
  EXPECT_EQ(length_unit_of("m"), std::nullopt);
  EXPECT_EQ(length_unit_of("inch"), std::nullopt);
}

}  // namespace
}  // namespace rubsweep::model
