#include "maps/config/support.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

const std::string brass =
    "{length_m: 0.01, rotor: {radius_m: 0.005, youngs_modulus_pa: 2.06e11, poisson_ratio: 0.3}, casing: "
    "{shape: flat, "
    "youngs_modulus_pa: 1.0e11, poisson_ratio: 0.34}, design_force_n: 200}";

std::string with_hertz() {
  return replaced(test_file("minimal.yaml"), "stiffness_n_per_m: 2.0e6", "hertz: " + brass);
}

TEST(Hertz, GivesTheStiffness) {
  const RunConfig config = read_run_config_text(with_hertz(), "test.yaml", {});
  const model::Stop& stop = config.study.machine.stops.at(0);
  ASSERT_TRUE(stop.hertz);
  EXPECT_EQ(stop.hertz->casing_shape, model::HertzShape::flat);
  EXPECT_EQ(stop.stiffness_n_per_m, contact::hertz_stiffness_n_per_m(*stop.hertz));
}

TEST(Hertz, WhatIsPrintedReadsBackTheSame) {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{},
        {"stops.0.hertz.half_width=paper"},
        {"stops.0.hertz.casing.shape=hole", "stops.0.hertz.casing.radius_m=0.006"}}) {
    const std::string printed = print_config(read_run_config_text(with_hertz(), "test.yaml", overrides));
    EXPECT_NE(printed.find("hertz:"), std::string::npos);
    EXPECT_EQ(printed.find("stiffness_n_per_m"), std::string::npos);
    EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  }
}

TEST(Hertz, ProblemsHaveTheirPlaces) {
  const auto message = [](const std::string& override) { return message_of(with_hertz(), {override}); };
  const std::string both =
      replaced(with_hertz(), "    contact_radius_m", "    stiffness_n_per_m: 1\n    contact_radius_m");
  EXPECT_NE(message_of(both).find("stops.0.hertz: given beside stiffness_n_per_m, allowed: one of the two"),
            std::string::npos);
  EXPECT_NE(message("stops.0.hertz.casing.shape=cylinder").find("stops.0.hertz.casing.radius_m: missing"),
            std::string::npos);
  EXPECT_NE(
      message("stops.0.hertz.casing={shape: hole, radius_m: 0.004, youngs_modulus_pa: 1, poisson_ratio: 0}")
          .find("the rotor does not fit into the hole"),
      std::string::npos);
  EXPECT_NE(message("stops.0.hertz.rotor.poisson_ratio=0.7").find("0.7 is out of range"), std::string::npos);
  EXPECT_NE(message("stops.0.hertz.half_width=book").find("'book' is unknown"), std::string::npos);
  EXPECT_NE(message("stops.0.hertz.length_m=1e-6")
                .find("stops.0.hertz.design_force_n: the contact is wider than long"),
            std::string::npos);
}

TEST(Hertz, IterationsAreWrittenWhereThereAreSome) {
  EXPECT_EQ(print_config(read_run_config_text(with_hertz(), "test.yaml", {})).find("hertz_iterations"),
            std::string::npos);
  const RunConfig config = read_run_config_text(with_hertz(), "test.yaml", {"response.hertz_iterations=4"});
  EXPECT_EQ(config.study.hertz_iterations, 4);
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("hertz_iterations: 4"), std::string::npos);
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  EXPECT_NE(message_of(with_hertz(), {"response.hertz_iterations=21"}).find("response.hertz_iterations: 21"),
            std::string::npos);
}

TEST(HertzFrictionCurve, IsSolvedForAndPrintedAsItWasGiven) {
  const std::string curve =
      "stops.0.friction={static: 0.3, kinetic: 0.2, peak_speed_m_per_s: 0.01, settle_speed_m_per_s: 0.2}";
  const RunConfig config = read_run_config_text(test_file("minimal.yaml"), "test.yaml", {curve});
  EXPECT_NEAR(contact::friction_coefficient(config.study.machine.stops.at(0).friction, 3), 0.2, 1e-12);
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("static: 0.3"), std::string::npos);
  EXPECT_EQ(printed.find("stribeck"), std::string::npos);
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
}

TEST(HertzFrictionCurve, ProblemsHaveTheirPlaces) {
  const auto message = [](const std::string& text) {
    return message_of(test_file("minimal.yaml"), {"stops.0.friction=" + text});
  };
  EXPECT_NE(message("{static: 0.1, kinetic: 0.2, peak_speed_m_per_s: 0.01, settle_speed_m_per_s: 0.2}")
                .find("stops.0.friction.static: below kinetic"),
            std::string::npos);
  EXPECT_NE(message("{static: 0.3, kinetic: 0.2, peak_speed_m_per_s: 0.1, settle_speed_m_per_s: 1e29}")
                .find("settle_speed_m_per_s: too far from the peak, allowed: at most 1e6 peak_speed_m_per_s"),
            std::string::npos);
  EXPECT_NE(message("{static: 0.3, kinetic: 0.2, peak_speed_m_per_s: 0.1, settle_speed_m_per_s: 0.12}")
                .find("settle_speed_m_per_s: too close to the peak"),
            std::string::npos);
  EXPECT_NE(message("{static: 0.3}").find("stops.0.friction.kinetic: missing"), std::string::npos);
  EXPECT_NE(message("{static: 0.3, kinetic: 0.2, coefficient: 1}").find("given beside"), std::string::npos);
}

TEST(HertzStaticFrictionKeys, AreReadPrintedAndReadAgain) {
  for (const std::string law :
       {"{static: 0.3, coefficient: 0.2}",
        "{static: 0.3, coefficient: 0.2, stribeck_speed_m_per_s: 0.05, exponent: 2}"}) {
    const RunConfig config =
        read_run_config_text(test_file("minimal.yaml"), "test.yaml", {"stops.0.friction=" + law});
    const model::Friction& friction = config.study.machine.stops.at(0).friction;
    EXPECT_EQ(model::holding_and_sliding(friction), (std::array{0.3, 0.2}));
    const std::string printed = print_config(config);
    EXPECT_NE(printed.find("static: 0.3"), std::string::npos);
    EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  }
}

TEST(HertzStaticFrictionKeys, ProblemsHaveTheirPlaces) {
  const auto message = [](const std::string& text, const std::string& more = "gravity_m_per_s2=0") {
    return message_of(test_file("minimal.yaml"), {"stops.0.friction=" + text, more});
  };
  const auto expect = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(message(text).find(part), std::string::npos) << message(text);
  };
  expect("{static: 0.1, coefficient: 0.2}",
         "stops.0.friction.static: below the sliding friction, allowed: a number no less than coefficient");
  expect("{static: 0.1, coefficient: 0.2, stribeck_speed_m_per_s: 1, exponent: 1}",
         "below the sliding friction");
  expect("{static: 0.3, coefficient: 0.2, stribeck_speed_m_per_s: 1, exponent: 3}",
         "stops.0.friction.exponent: 3 is out of range");
  expect("{static: 0.3, coefficient: 0.2, stribeck_speed_m_per_s: 1, exponent: 1.5}",
         "stops.0.friction.exponent: 1.5 is not an integer");
  expect("{static: 0.3, coefficient: 0.2, stribeck_speed_m_per_s: 0, exponent: 1}",
         "stops.0.friction.stribeck_speed_m_per_s: 0");
  expect("{static: 0.3, coefficient: 0.2, exponent: 1}", "stops.0.friction.stribeck_speed_m_per_s: missing");
  expect("{static: 0.3, coefficient: 0.2, stribeck_speed_m_per_s: 1}", "stops.0.friction.exponent: missing");
  expect("{coefficient: 0.2, stribeck_speed_m_per_s: 1, exponent: 1}", "one key is missing");
  expect("{static: 0.3, stribeck_speed_m_per_s: 1, exponent: 1}", "stops.0.friction.coefficient: missing");
  expect("{static: 0.3, coefficient: 0.2, one_way: 0.1}", "given beside");
  EXPECT_NE(message("{static: 0.3, coefficient: 0.2}", "solver={method: adaptive, contact: smoothed}")
                .find("solver: smooths the contact, beside static friction"),
            std::string::npos);
}

TEST(HertzStaticFrictionKeys, AreWrittenOverOtherFriction) {
  const auto after = [](const std::string& base, std::vector<std::string> over) {
    over.insert(over.begin(), "stops.0.friction=" + base);
    return read_run_config_text(test_file("minimal.yaml"), "test.yaml", over)
        .study.machine.stops.at(0)
        .friction;
  };
  const std::string curve =
      "{static: 0.3, kinetic: 0.2, peak_speed_m_per_s: 0.01, settle_speed_m_per_s: 0.2}";
  EXPECT_TRUE(std::holds_alternative<model::StaticFriction>(
      after("{coefficient: 0.2}", {"stops.0.friction.static=0.3"})));
  // The static coefficient of a curve must not remain as a limit.
  EXPECT_TRUE(
      std::holds_alternative<model::ConstantFriction>(after(curve, {"stops.0.friction.coefficient=0.1"})));
  EXPECT_EQ(model::holding_and_sliding(
                after("{static: 0.3, coefficient: 0.2}", {"stops.0.friction.coefficient=0.1"})),
            (std::array{0.3, 0.1}));
  EXPECT_TRUE(std::holds_alternative<model::StribeckFriction>(
      after("{coefficient: 0.2}",
            {"stops.0.friction.static=0.3", "stops.0.friction.kinetic=0.2",
             "stops.0.friction.peak_speed_m_per_s=0.01", "stops.0.friction.settle_speed_m_per_s=0.2"})));
}

}  // namespace
}  // namespace rubsweep::config::machine
