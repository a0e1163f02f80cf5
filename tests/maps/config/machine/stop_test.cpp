#include "rubsweep/maps/config/machine/stop.hpp"

#include <cmath>

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::machine {
namespace {

model::Stop read_stop_with(const std::vector<std::string>& overrides) {
  std::string text = replaced(test_file("minimal.yaml"), "    restitution: 0.7\n", "");
  return read_run_config_text(text, "test.yaml", overrides).study.machine.stops.at(0);
}

TEST(Stop, TakesEachSourceOfDamping) {
  const model::Stop nominal = read_stop_with({"stops.0.restitution=0.7"});
  EXPECT_EQ(std::get<model::NominalRestitution>(nominal.damping).value, 0.7);
  const model::Stop delivered = read_stop_with({"stops.0.restitution_delivered=0.6"});
  EXPECT_EQ(std::get<model::DeliveredRestitution>(delivered.damping).value, 0.6);
  const model::Stop given = read_stop_with({"stops.0.damping_ns_per_m=0"});
  EXPECT_EQ(std::get<model::ExplicitDamping>(given.damping).damping_ns_per_m, 0);
  EXPECT_THROW(read_stop_with({}), ConfigError);
}

TEST(Stop, TakesARestitutionByTheMassOfTheRotor) {
  const model::Stop printed = read_stop_with({"stops.0.restitution_by_rotor_mass=0.7"});
  EXPECT_EQ(std::get<model::RestitutionByRotorMass>(printed.damping).value, 0.7);
  // A new kind of damping replaces the previous one.
  const model::Stop delivered =
      read_stop_with({"stops.0.restitution_by_rotor_mass=0.7", "stops.0.restitution_delivered=0.6"});
  EXPECT_EQ(std::get<model::DeliveredRestitution>(delivered.damping).value, 0.6);
}

/// The minimal configuration with this law instead of the stop's stiffness and restitution.
std::string with_law(const std::string& law) {
  return replaced(replaced(test_file("minimal.yaml"), "    restitution: 0.7\n", ""),
                  "    stiffness_n_per_m: 2.0e6\n", "    law: " + law + "\n");
}

TEST(Stop, TakesEachLaw) {
  const auto stop = [](const std::string& law) {
    return read_run_config_text(with_law(law), "test.yaml", {}).study.machine.stops.at(0);
  };
  const model::Stop power = stop("{kind: power, stiffness_n_per_m_n: 1e9, exponent: 1.5}");
  EXPECT_EQ(power.law.kind, model::ForceCurve::power);
  EXPECT_NEAR(power.stiffness_n_per_m, 1e9 * std::sqrt(5e-5), 1);
  const model::Stop damped = stop(
      "{kind: table, penetration_m: [0, 1e-4], force_n: [0, 5], damping: delivered, restitution: 0.4, "
      "approach_speed_m_per_s: 0.2}");
  EXPECT_EQ(damped.law.damping, model::ImpactDamping::delivered);
  EXPECT_EQ(damped.law.approach_speed_m_per_s, 0.2);
  EXPECT_NEAR(damped.stiffness_n_per_m, 5e4, 1e-6);
  EXPECT_TRUE(read_stop_with({"stops.0.law=linear", "stops.0.stiffness_n_per_m=1e6", "stops.0.restitution=1"})
                  .law.linear());
}

TEST(Stop, ALawTakesThePlaceOfLinearKeysAndBack) {
  const auto config = [](const std::string& law, const std::vector<std::string>& overrides) {
    return read_run_config_text(law, "test.yaml", overrides).study.machine.stops.at(0);
  };
  const std::string power = "{kind: power, stiffness_n_per_m_n: 1e9, exponent: 1.5}";
  EXPECT_EQ(config(test_file("minimal.yaml"), {"stops.0.law=" + power}).law.exponent, 1.5);
  EXPECT_EQ(config(with_law(power), {"stops.0.law.exponent=1.25"}).law.exponent, 1.25);
  EXPECT_TRUE(
      config(with_law(power), {"stops.0.stiffness_n_per_m=1e6", "stops.0.restitution=1"}).law.linear());
}

TEST(Stop, LawsArePrintedAsTheyAreRead) {
  for (const std::string law :
       {"{kind: power, stiffness_n_per_m_n: 1e9, exponent: 1.5, damping: flores, restitution: 0.5}",
        "{kind: table, penetration_m: [0, 1e-4, 3e-4], force_n: [0, 5, 6]}"}) {
    const std::string printed = print_config(read_run_config_text(with_law(law), "test.yaml", {}));
    EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
    EXPECT_EQ(printed.find("\n    stiffness_n_per_m:"), std::string::npos) << printed;
    EXPECT_NE(printed.find("\n    law:\n"), std::string::npos) << printed;
  }
  EXPECT_EQ(print_config(read_run_config_text(test_file("minimal.yaml"), "test.yaml", {})).find("law"),
            std::string::npos);
}

TEST(Stop, ANameIsPrintedAsItIsRead) {
  const auto read = [](const std::string& text) { return read_run_config_text(text, "test.yaml", {}); };
  EXPECT_EQ(read(test_file("minimal.yaml")).study.stop_names, std::vector<std::string>{""});
  const RunConfig config = read(replaced(test_file("minimal.yaml"), "    restitution: 0.7\n",
                                         "    restitution: 0.7\n    name: \"seal: 2\"\n"));
  EXPECT_EQ(config.study.stop_names, std::vector<std::string>{"seal: 2"});
  EXPECT_EQ(read(print_config(config)).study.stop_names, config.study.stop_names);
}

TEST(Stop, HertzLineIsTheLawOfTheContactThatGivesTheSecant) {
  const std::string hertz =
      "    hertz:\n      length_m: 0.01\n      rotor: {radius_m: 0.02, youngs_modulus_pa: 2e11, "
      "poisson_ratio: "
      "0.3}\n      casing: {shape: flat, youngs_modulus_pa: 2e11, poisson_ratio: 0.3}\n      design_force_n: "
      "100\n";
  const std::string text = replaced(with_law("{kind: hertz_line, damping: flores, restitution: 0.5}"),
                                    "    contact_radius_m", hertz + "    contact_radius_m");
  const RunConfig config = read_run_config_text(text, "test.yaml", {});
  EXPECT_EQ(config.study.machine.stops.at(0).law.kind, model::ForceCurve::hertz_line);
  EXPECT_FALSE(config.study.machine.stops.at(0).by_hertz_secant());
  const std::string printed = print_config(config);
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
}

TEST(Stop, AsksAboutAStiffnessOfAnotherUnit) {
  const auto questions = [](const std::string& stiffness) {
    return read_run_config_text(
               with_law("{kind: power, exponent: 1.5, stiffness_n_per_m_n: " + stiffness + "}"), "test.yaml",
               {})
        .questions;
  };
  EXPECT_TRUE(questions("1e9").empty());
  EXPECT_FALSE(questions("3e4").empty());
  EXPECT_FALSE(questions("1e15").empty());
}

TEST(Stop, TakesEachFriction) {
  const std::string elastic = "stops.0.restitution=1";
  const auto friction = [&](const std::string& text) {
    return read_stop_with({elastic, "stops.0.friction=" + text}).friction;
  };
  EXPECT_TRUE(std::holds_alternative<model::NoFriction>(friction("none")));
  EXPECT_EQ(std::get<model::ConstantFriction>(friction("{coefficient: 0.2}")).coefficient, 0.2);
  EXPECT_EQ(std::get<model::StribeckFriction>(friction("{stribeck: [1, 3, 2, 4, 5, 6]}")).gamma,
            (std::array<double, 6>{1, 3, 2, 4, 5, 6}));
}

TEST(Stop, NoSpellingOfFrictionMayDrive) {
  const auto message = [](const std::string& text) {
    return message_of(test_file("minimal.yaml"), {"stops.0.friction=" + text});
  };
  EXPECT_NE(
      message("{stribeck: [0, 0, 0, -0.1, 100, 0]}")
          .find(
              "stops.0.friction.stribeck: gives a coefficient of -0.1 at a slip of 0.1954 m/s, which drives "
              "the slip, allowed: a coefficient >= 0 at every slip"),
      std::string::npos)
      << message("{stribeck: [0, 0, 0, -0.1, 100, 0]}");
  for (const char* driving :
       {"{stribeck: [0.3, 10, 100, 0.1, 1, 0]}", "{stribeck: [0, 0, 0, 0.1, 100, -1e-6]}",
        "{stribeck: [0, 0, 0, 0.1, -100, 0]}", "{coefficient: -0.1}", "{one_way: -0.1}"})
    EXPECT_FALSE(message(driving).empty()) << driving;
  EXPECT_NE(message("{stribeck: [0, 0, 0, 11, 100, 0]}").find("gives a coefficient of 11, allowed"),
            std::string::npos);
  EXPECT_FALSE(message("{coefficient: 11}").empty());
}

TEST(Stop, NoNumberIsBeyondWhatProductsBear) {
  const auto message = [](const std::string& override) {
    return message_of(test_file("minimal.yaml"), {override});
  };
  EXPECT_NE(message("stops.0.clearance_m=1e-300")
                .find("stops.0.clearance_m: 1e-300 is out of range, allowed: 1e-30 to 1e+30 in magnitude"),
            std::string::npos);
  for (const char* key : {"stops.0.stiffness_n_per_m=1e200", "rotor.mass_kg=1e-200",
                          "gravity_m_per_s2=1e-310", "stops.0.friction={stribeck: [0, 0, 0, 0.1, 1e290, 0]}",
                          "stops.0.casing={mass_kg: 1e-40, stiffness_n_per_m: 2, damping_ratio: 3}"})
    EXPECT_NE(message(key).find("in magnitude"), std::string::npos) << key;
}

TEST(StopKick, IsShorterThanTheLongestRun) {
  const std::string kick = "kick={force_n: 200, duration_s: 0.5}";
  EXPECT_EQ(message_of(test_file("minimal.yaml"), {kick, "response.max_revolutions=130"}), "no error");
  const std::string slow = message_of(test_file("minimal.yaml"), {kick, "sweep.speed_hz=300"});
  EXPECT_EQ(slow, "no error");
  EXPECT_NE(message_of(test_file("minimal.yaml"),
                       {"kick={force_n: 200, duration_s: 3}", "response.max_revolutions=130"})
                .find("kick.duration_s: 3 s are no shorter than a run, 2.167 s, allowed: less than "
                      "response.max_revolutions / speed"),
            std::string::npos);
}

TEST(Stop, TakesEachCasing) {
  const std::string elastic = "stops.0.restitution=1";
  EXPECT_FALSE(read_stop_with({elastic, "stops.0.casing=rigid"}).casing);
  const auto casing =
      read_stop_with({elastic, "stops.0.casing={mass_kg: 1, stiffness_n_per_m: 2, damping_ratio: 3}"}).casing;
  ASSERT_TRUE(casing);
  EXPECT_EQ(casing->mass_kg, 1);
  EXPECT_EQ(casing->stiffness_n_per_m, 2);
  EXPECT_EQ(casing->damping_ratio, 3);
}

TEST(Stop, KeepsTheOrderOfTheList) {
  const std::string minimal = test_file("minimal.yaml");
  const std::size_t begin = minimal.find("  - kind");
  const std::size_t end = minimal.find("sweep:");
  std::string text = minimal;
  text.insert(end, replaced(minimal.substr(begin, end - begin), "angle_deg: 90", "angle_deg: 270"));
  const auto stops = read_run_config_text(text, "two.yaml", {}).study.machine.stops;
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(std::get<model::OneSideGeometry>(stops[0].geometry).angle_deg, 90);
  EXPECT_EQ(std::get<model::OneSideGeometry>(stops[1].geometry).angle_deg, 270);
}

TEST(Stop, AnnularWithAndWithoutOffset) {
  const std::string annular = replaced(test_file("minimal.yaml"), "kind: one_side", "kind: annular");
  const std::string centred = replaced(annular, "angle_deg: 90", "offset_m: [0, 0]");
  const auto ring_of = [](const std::string& text) {
    const auto stops = read_run_config_text(text, "f.yaml", {}).study.machine.stops;
    return std::get<model::AnnularGeometry>(stops[0].geometry).offset_m;
  };
  EXPECT_EQ(ring_of(centred), (std::array<double, 2>{0, 0}));
  EXPECT_EQ(ring_of(replaced(centred, "[0, 0]", "[1e-4, -2e-4]")), (std::array<double, 2>{1e-4, -2e-4}));
}

}  // namespace
}  // namespace rubsweep::config::machine
