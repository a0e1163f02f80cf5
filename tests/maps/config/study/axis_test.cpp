#include "rubsweep/maps/config/study/axis.hpp"

#include "maps/config/study/with_sweep_lines.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/maps/config/print_config.hpp"
#include "rubsweep/maps/config/study_digest.hpp"

namespace rubsweep::config::study {
namespace {

RunConfig with_axes(const std::string& axes, const std::vector<std::string>& overrides = {}) {
  return read_run_config_text(with_sweep_lines(axes), "test.yaml", overrides);
}

std::string speed_problem(const std::string& speed) {
  return message_of(with_sweep_lines(speed + "\n  " + ratio));
}

TEST(Axis, ByStepsIsTheListOfItsDecimals) {
  const RunConfig stepped = with_axes("speed_hz: {from: 30, to: 30.4, step: 0.1}\n  " + ratio),
                  listed = with_axes("speed_hz: {values: [30, 30.1, 30.2, 30.3, 30.4]}\n  " + ratio);
  EXPECT_EQ(stepped.study.grid.speed_hz, listed.study.grid.speed_hz);
  EXPECT_EQ(study_digest(stepped.study), study_digest(listed.study));
}

TEST(Axis, ByStepsInRevolutionsPerMinuteIsTheListInThem) {
  EXPECT_EQ(with_axes("speed_rpm: {from: 3600, to: 3000, step: 100}\n  " + ratio).study.grid.speed_hz,
            with_axes("speed_rpm: {values: [3600, 3500, 3400, 3300, 3200, 3100, 3000]}\n  " + ratio)
                .study.grid.speed_hz);
}

TEST(Axis, ByStepsIsPrintedAsItWasWritten) {
  const RunConfig config = with_axes(
      "speed_rpm: {from: 3000, to: 3600, step: 100}\n  whirl_ratio: {from: 0.1, to: 0.9, step: 0.1}");
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("  speed_rpm:\n    from: 3000\n    to: 3600\n    step: 100\n"), std::string::npos)
      << printed;
  EXPECT_NE(printed.find("  whirl_ratio:\n    from: 0.1\n    to: 0.9\n    step: 0.1\n"), std::string::npos)
      << printed;
  const RunConfig again = read_run_config_text(printed, "printed.yaml", {});
  EXPECT_EQ(print_config(again), printed);
  EXPECT_EQ(again.study.grid.speed_hz, config.study.grid.speed_hz);
}

TEST(Axis, StepAndCountTakeEachOtherBack) {
  const std::string counted = "speed_hz: {from: 30, to: 60, count: 4, scale: log}\n  " + ratio,
                    stepped = "speed_hz: {from: 30, to: 60, step: 5}\n  " + ratio;
  EXPECT_EQ(with_axes(counted, {"sweep.speed_hz.step=15"}).study.grid.speed_hz,
            (std::vector<double>{30, 45, 60}));
  EXPECT_EQ(with_axes(stepped, {"sweep.speed_hz.count=2"}).study.grid.speed_hz,
            (std::vector<double>{30, 60}));
}

TEST(Axis, RefusesStepsThatDoNotMeetTheEnd) {
  EXPECT_EQ(
      speed_problem("speed_hz: {from: 30, to: 60, step: 0.7}"),
      "test.yaml:6:38: sweep.speed_hz.step: no whole number of steps of 0.7 leads from 30 to 60 (to 59.4 or "
      "60.1?), allowed: a step that meets both ends");
  EXPECT_EQ(speed_problem("speed_hz: {from: 30.000000000000007, to: 60, step: 7}"),
            "test.yaml:6:54: sweep.speed_hz.step: no whole number of steps of 7 leads from "
            "30.000000000000007 to 60, "
            "allowed: numbers that do not span more than 15 digits");
  EXPECT_EQ(speed_problem("speed_hz: {from: 30, to: 60, step: 0}"),
            "test.yaml:6:38: sweep.speed_hz.step: 0 is out of range, allowed: a number > 0");
  EXPECT_EQ(speed_problem("speed_hz: {from: 30, step: 1}"),
            "test.yaml:6:13: sweep.speed_hz.to: missing, allowed: a number > 0");
  EXPECT_EQ(speed_problem("speed_hz: {from: 30, to: 60, step: 0.001}"),
            "test.yaml:6:38: sweep.speed_hz.step: gives 30001 values, allowed: at most 10000 values");
}

TEST(Axis, RefusesACountBesideAStep) {
  EXPECT_EQ(speed_problem("speed_hz: {from: 30, to: 60, step: 1, count: 31}"),
            "test.yaml:6:48: sweep.speed_hz.count: given beside step, allowed: a number, {from, to, count}, "
            "{from, to, "
            "step} or {values: [...]}");
}

}  // namespace
}  // namespace rubsweep::config::study
