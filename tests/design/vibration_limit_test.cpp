#include "rubsweep/design/vibration_limit.hpp"

#include <gtest/gtest.h>

#include "rubsweep/error.hpp"
#include "scene/kit_machine.hpp"

namespace rubsweep::design {
namespace {

TEST(VibrationLimit, IsOneMilUpToTwelveThousandRevolutionsAMinute) {
  EXPECT_DOUBLE_EQ(vibration_limit_m(3000 / 60.0), 25.4e-6);
  EXPECT_DOUBLE_EQ(vibration_limit_m(12000 / 60.0), 25.4e-6);
}

/// Half of it at four times the speed: by 12000 / N without its root it would be a quarter.
TEST(VibrationLimit, FallsWithTheRootOfTheSpeedBeyond) {
  EXPECT_DOUBLE_EQ(vibration_limit_m(48000 / 60.0), 12.7e-6);
  EXPECT_NEAR(vibration_limit_m(24000 / 60.0), 17.9605e-6, 1e-10);
}

TEST(VibrationLimit, EccentricityOfTheAnalysisOfAJeffcottRotorDependsOnTheSpeedAlone) {
  // 4 x 6350 W / N g mm on a rotor of W kg.
  EXPECT_NEAR(analysis_eccentricity_m(scene::one_side_machine(), 12000 / 60.0), 4 * 6350.0 / 12000 * 1e-6,
              1e-15);
}

TEST(VibrationLimit, EccentricityOfTheAnalysisOfAKitIsForTheMassOfTheWholeRotor) {
  model::Machine machine = scene::light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.discs[0].eccentricity_ratio = 0.5;
  EXPECT_NEAR(analysis_eccentricity_m(machine, 100), 2 * 4 * 6350.0 / 6000 * 1e-6, 1e-12);
  kit.discs[0].eccentricity_ratio = 0;
  EXPECT_THROW(analysis_eccentricity_m(machine, 100), ConfigError);
}

TEST(VibrationLimit, ScaleFactorBringsTheResponseToTheLimitFromHalfToSixfold) {
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 10e-6), 2.5);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 40e-6), 0.625);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 60e-6), 0.5);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 1e-6), 6);
  EXPECT_DOUBLE_EQ(scale_factor(25e-6, 0), 6);
}

}  // namespace
}  // namespace rubsweep::design
