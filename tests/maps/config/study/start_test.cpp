#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/study/study.hpp"

namespace rubsweep::config::study {
namespace {

/// One stop on a moving casing, and one rigid stop.
const std::vector<std::string> two_stops{
    "stops=[{kind: one_side, angle_deg: 90, clearance_m: 1e-3, stiffness_n_per_m: 2e6, restitution: 0.7, "
    "contact_radius_m: 0.02}, {kind: one_side, angle_deg: -90, clearance_m: 1e-3, stiffness_n_per_m: 2e6, "
    "restitution: 0.7, contact_radius_m: 0.02, casing: {mass_kg: 0.05, stiffness_n_per_m: 5e5, "
    "damping_ratio: 0.1}}]"};

RunConfig with_two_stops(std::vector<std::string> overrides) {
  overrides.insert(overrides.begin(), two_stops.begin(), two_stops.end());
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml", overrides);
}

std::string start_problem(const std::string& override_text) {
  return message_of(test_file("minimal.yaml"), {two_stops[0], override_text});
}

TEST(Start, ReadsRotorAndCasingsAndPrintsThemBack) {
  const RunConfig config =
      with_two_stops({"start={x_m: 1e-3, vy_m_per_s: -0.5, casings: {1: {vx_m_per_s: 0.25}}}"});
  const model::Start& start = config.study.machine.start.value();
  EXPECT_EQ(start.rotor.x_m, 1e-3);
  EXPECT_EQ(start.rotor.y_m, std::nullopt);
  EXPECT_EQ(start.rotor.vy_m_per_s, -0.5);
  ASSERT_EQ(start.casings.size(), 2u);
  EXPECT_FALSE(start.casings[0]);
  EXPECT_EQ(start.casings[1].value().vx_m_per_s, 0.25);
  const std::string printed = print_config(config);
  EXPECT_NE(
      printed.find("start:\n  x_m: 0.001\n  vy_m_per_s: -0.5\n  casings:\n    1:\n      vx_m_per_s: 0.25\n"),
      std::string::npos)
      << printed;
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
}

TEST(Start, AnEmptyOneReadsBackAndIsNotTheSameStudy) {
  const RunConfig empty = with_two_stops({"start={}"});
  ASSERT_TRUE(empty.study.machine.start);
  const std::string printed = print_config(empty);
  EXPECT_TRUE(read_run_config_text(printed, "printed.yaml", {}).study.machine.start);
  EXPECT_NE(study_digest(empty.study), study_digest(with_two_stops({}).study));
}

TEST(Start, AtRestReadsBackAndIsAStudyOfItsOwn) {
  const RunConfig rest = with_two_stops({"start=rest"});
  EXPECT_TRUE(rest.study.machine.start.value().at_rest);
  const std::string printed = print_config(rest);
  EXPECT_NE(printed.find("\nstart: rest\n"), std::string::npos) << printed;
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  EXPECT_NE(study_digest(rest.study), study_digest(with_two_stops({"start={}"}).study));
}

TEST(Start, AtRestHasNoNumbersAndNoOtherWord) {
  EXPECT_EQ(start_problem("start=rst"),
            "--set start=rst: start: 'rst' is unknown (did you mean 'rest'?), allowed: rest, or a map of "
            "x_m, y_m, vx_m_per_s, vy_m_per_s, casings, each optional");
  EXPECT_EQ(
      start_problem("start=[rest]"),
      "--set start=[rest]: start: is a list, allowed: rest, or a map of x_m, y_m, vx_m_per_s, vy_m_per_s, "
      "casings, each optional");
  const std::string text = test_file("minimal.yaml") + "start: rest\n";
  EXPECT_EQ(message_of(text, {"start.x_m=1e-3"}),
            "--set start.x_m=1e-3: start: is 'rest' and cannot hold 'x_m', allowed: a map or a list");
}

TEST(Start, TakesAKickBackAndAKickAStart) {
  const RunConfig started = with_two_stops({"kick={force_n: 200, duration_s: 0.005}", "start={}"});
  EXPECT_FALSE(started.study.machine.kick);
  const RunConfig kicked = with_two_stops({"start={x_m: 1}", "kick={force_n: 200, duration_s: 0.005}"});
  EXPECT_FALSE(kicked.study.machine.start);
}

TEST(Start, IsReachedByAxes) {
  const auto study = with_two_stops({"start={}", "sweep.x={key: start.casings.1.y_m, values: [0, 1e-5]}",
                                     "sweep.y={key: start.vx_m_per_s, values: [0.5]}"})
                         .study;
  const model::Start start = study.with_keys(sweep::key_values(study.grid, 1)).machine.start.value();
  EXPECT_EQ(start.casings.at(1).value().y_m, 1e-5);
  EXPECT_EQ(start.rotor.vx_m_per_s, 0.5);
}

TEST(Start, RefusesWhatItCannotBe) {
  EXPECT_EQ(
      start_problem("start={z_m: 1}"),
      "--set start={z_m: 1}: start.z_m: unknown key (did you mean 'x_m'?), allowed: x_m, y_m, vx_m_per_s, "
      "vy_m_per_s, casings");
  EXPECT_EQ(start_problem("start={x_m: 101}"),
            "--set start={x_m: 101}: start.x_m: 101 is out of range, allowed: a number >= -100 and <= 100");
  EXPECT_EQ(
      start_problem("start={casings: {0: {x_m: 0}}}"),
      "--set start={casings: {0: {x_m: 0}}}: start.casings.0: is of a rigid casing, which has no state, "
      "allowed: a casing that moves");
  EXPECT_EQ(start_problem("start={casings: {2: {x_m: 0}}}"),
            "--set start={casings: {2: {x_m: 0}}}: start.casings.2: unknown key (did you mean '0'?), "
            "allowed: 0, 1");
}

TEST(Start, RefusesAKickBesideIt) {
  const std::string text = test_file("minimal.yaml") + "kick: {force_n: 1, duration_s: 1e-3}\nstart: {}\n";
  const std::string message = message_of(text, {});
  EXPECT_NE(message.find("start: is given beside a kick, allowed: one of the two, or rest"),
            std::string::npos)
      << message;
}

TEST(Start, AKickMayStandBesideRest) {
  const std::string text = test_file("minimal.yaml") + "kick: {force_n: 1, duration_s: 1e-3}\nstart: rest\n";
  const RunConfig both = read_run_config_text(text, "both.yaml", {});
  EXPECT_TRUE(both.study.machine.kick);
  EXPECT_TRUE(both.study.machine.start.value().at_rest);
  EXPECT_EQ(print_config(read_run_config_text(print_config(both), "again.yaml", {})), print_config(both));
  const RunConfig written_over = read_run_config_text(text, "both.yaml", {"start={y_m: 1e-4}"});
  EXPECT_FALSE(written_over.study.machine.kick) << "a state replaces the kick";
}

}  // namespace
}  // namespace rubsweep::config::study
