#include "rubsweep/maps/config/study/axis.hpp"

#include <cmath>

#include "maps/config/study/with_sweep_lines.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"

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

const std::vector<std::string> kick{"kick={force_n: 200, duration_s: 0.005}"};

RunConfig with_kick(std::vector<std::string> overrides) {
  overrides.insert(overrides.begin(), kick.begin(), kick.end());
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml", overrides);
}

std::string axes_problem(const std::string& axes) {
  const std::string message = message_of(test_file("minimal.yaml"), {kick[0],
                                                                     "sweep={speed_hz: {values: [60]}, "
                                                                     "whirl_ratio: {values: [0.5]}, " +
                                                                         axes + "}"});
  return message.substr(message.find("}}: ") == std::string::npos ? 0 : message.rfind("}}: ") + 4);
}

TEST(AxisKeyAxisAxes, ReadKeysTheirFactorsAndTheirValues) {
  const auto axes = with_kick({"sweep.x={key: kick.force_n, from: 100, to: 400, count: 3, scale: log}",
                               "sweep.y={keys: [stops.0.restitution, gravity_m_per_s2], factors: [1, 9.81], "
                               "values: [0.5, 1]}"})
                        .study.grid.axes;
  ASSERT_EQ(axes.size(), 2u);
  EXPECT_EQ(axes[0].keys, std::vector<std::string>{"kick.force_n"});
  EXPECT_EQ(axes[0].factors, std::vector<double>{1});
  ASSERT_EQ(axes[0].values.size(), 3u);
  EXPECT_EQ(axes[0].values.front(), 100);
  EXPECT_NEAR(axes[0].values[1], 200, 1e-10);
  EXPECT_EQ(axes[0].values.back(), 400);
  EXPECT_EQ(axes[1].keys, (std::vector<std::string>{"stops.0.restitution", "gravity_m_per_s2"}));
  EXPECT_EQ(axes[1].factors, (std::vector<double>{1, 9.81}));
}

TEST(AxisKeyAxisAxes, VaryTheStudyAsSetWould) {
  const auto study =
      with_kick(
          {"sweep.x={keys: [kick.force_n, stops.0.clearance_m], factors: [1, 1e-5], values: [100, 150]}"})
          .study;
  const sweep::Study varied = study.with_keys(sweep::key_values(study.grid, 1));
  const sweep::Study set = with_kick({"kick.force_n=150", "stops.0.clearance_m=0.0015"}).study;
  EXPECT_EQ(print_study(varied), print_study(set));
}

TEST(AxisKeyAxisAxes, ReachWhatThePrintedStudyLeavesOut) {
  const auto study = with_kick({"sweep.x={key: kick.angle_deg, values: [0, 45]}"}).study;
  EXPECT_FALSE(study.machine.kick->angle_deg);
  EXPECT_EQ(study.with_keys(sweep::key_values(study.grid, 1)).machine.kick->angle_deg, 45);
}

TEST(AxisKeyAxisAxes, TakeBackWhatSaysTheSameByOtherMeans) {
  const auto study = with_kick({"sweep.x={key: stops.0.restitution_delivered, values: [0.6]}"}).study;
  const auto varied = study.with_keys(sweep::key_values(study.grid, 0));
  EXPECT_EQ(std::get<model::DeliveredRestitution>(varied.machine.stops[0].damping).value, 0.6);
}

TEST(AxisKeyAxisAxes, CountInTheDigestAndReadBackAsTheyWerePrinted) {
  const RunConfig plain = with_kick({}),
                  swept = with_kick({"sweep.x={key: kick.force_n, values: [100, 150]}"}),
                  tied = with_kick({"sweep.x={keys: [kick.force_n], factors: [2], values: [100, 150]}"});
  EXPECT_NE(study_digest(plain.study), study_digest(swept.study));
  EXPECT_NE(study_digest(tied.study), study_digest(swept.study));
  for (const RunConfig& config : {swept, tied}) {
    const std::string printed = print_config(config);
    EXPECT_EQ(print_config(read_run_config_text(printed, "printed", {})), printed);
  }
}

TEST(AxisKeyAxisAxes, AreRefusedBeforeTheRun) {
  EXPECT_EQ(axes_problem("x: {key: kick.forc_n, values: [1]}").substr(0, 58),
            "kick.forc_n: unknown key (did you mean 'force_n'?), allowe");
  EXPECT_EQ(axes_problem("x: {key: stops.0.restitution, values: [0.5, 1.5]}"),
            "stops.0.restitution: 1.5 is out of range, allowed: a number > 0 and <= 1");
  EXPECT_EQ(axes_problem("x: {key: rotor.kind, values: [1]}").substr(0, 33),
            "rotor.kind: 'jeffcott', no number");
  EXPECT_EQ(axes_problem("x: {key: stops.0, values: [1]}").substr(0, 25), "stops.0: is a map, no num");
  EXPECT_EQ(axes_problem("x: {key: stops.1.clearance_m, values: [1]}"),
            "stops: the list has no item '1', allowed: an index from 0 to 0");
  EXPECT_EQ(axes_problem("x: {key: speed_hz, values: [1]}"),
            "speed_hz: has an axis of its own, allowed: sweep.speed_hz");
  EXPECT_EQ(axes_problem("x: {key: output.directory, values: [1]}").substr(0, 40),
            "output.directory: is no key of an axis, ");
  EXPECT_EQ(axes_problem("x: {key: kick.force_n, values: [1]}, y: {key: kick.force_n, values: [2]}"),
            "sweep.y: 'kick.force_n' is swept twice, allowed: every key on one axis only");
  EXPECT_EQ(axes_problem("x: {keys: [kick.force_n, kick.force_n], values: [1]}"),
            "sweep.x.keys: 'kick.force_n' is there twice, allowed: every key once");
  EXPECT_EQ(axes_problem("x: {keys: [kick.force_n], factors: [0], values: [1]}"),
            "sweep.x.factors: vary nothing, allowed: a factor that is not 0");
  // Metres where millimetres were probably meant.
  EXPECT_NE(axes_problem("x: {key: stops.0.clearance_m, values: [0.001, 1]}").find("millimetres"),
            std::string::npos);
}

TEST(AxisKeyAxisAxes, NameTheirPlaceInTheFile) {
  const std::string text = test_file("minimal.yaml") + "kick: {force_n: 200, duration_s: 0.005}\n";
  std::string swept = text;
  const std::string mark = "sweep:\n";
  swept.insert(swept.find(mark) + mark.size(), "  x: {values: [-1], key: kick.force_n}\n");
  EXPECT_EQ(message_of(swept, {}, "test.yaml"),
            "test.yaml:11:26: kick.force_n: -1 is out of range, allowed: a number >= 0");
}

TEST(AxisKeyAxisAxes, NeedValuesThatALogarithmHas) {
  EXPECT_NE(axes_problem("x: {key: kick.force_n, from: 0, to: 9, count: 3, scale: log}").find("logarithmic"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config::study
