#include "rubsweep/maps/config/unit_slips.hpp"

#include "maps/config/support.hpp"

namespace rubsweep::config {
namespace {

std::vector<std::string> questions(const std::string& file, const std::vector<std::string>& overrides) {
  return read_run_config_text(test_file(file), "test.yaml", overrides).questions;
}

std::vector<std::string> of_minimal(const std::string& override) {
  return questions("minimal.yaml", {override});
}
std::vector<std::string> of_kit(const std::string& override) {
  return questions("rotor_kit.yaml", {override});
}

/// The single question about an override, without its place.
std::string asked(const std::vector<std::string>& all, const std::string& override) {
  if (all.size() != 1) return std::to_string(all.size()) + " questions";
  const std::string place = "--set " + override + ": ";
  return all.front().starts_with(place) ? all.front().substr(place.size()) : all.front();
}

struct Case {
  const char *override, *question;
};

class UnitSlipsQuestionOfAJeffcottRotor : public testing::TestWithParam<Case> {};
TEST_P(UnitSlipsQuestionOfAJeffcottRotor, NamesTheUnitThatExplainsTheNumber) {
  EXPECT_EQ(asked(of_minimal(GetParam().override), GetParam().override), GetParam().question);
}
INSTANTIATE_TEST_SUITE_P(
    Rules, UnitSlipsQuestionOfAJeffcottRotor,
    testing::Values(
        Case{"sweep.eccentricity_m=0.3", "sweep.eccentricity_m: 0.3 m is 300 clearances (millimetres?)"},
        Case{"sweep.eccentricity_m={from: 0.001, to: 2.95, count: 3}",
             "sweep.eccentricity_m.to: 2.95 m is 2950 clearances (millimetres?)"},
        Case{"sweep.eccentricity_m=50000", "sweep.eccentricity_m: 50000 m is 5e+07 clearances"},
        Case{"sweep.unbalance_g_mm=24e3",
             "sweep.unbalance_g_mm: 24000 g mm is an eccentricity of 30 clearances"},
        Case{"sweep.whirl_ratio={from: 2, to: 98, count: 5}",
             "sweep.whirl_ratio.to: 98 times the clearance is no quiet motion (per cent?)"},
        Case{"stops.0.stiffness_n_per_m=2000",
             "stops.0.stiffness_n_per_m: 2000 N/m is softer than a tenth of the rotor (newtons per "
             "millimetre?)"},
        Case{"stops.0.angle_deg=1.5708", "stops.0.angle_deg: 1.5708 degrees is 0.5 pi (radians?)"},
        Case{"stops.0.angle_deg=-3.14", "stops.0.angle_deg: -3.14 degrees is -0.9995 pi (radians?)"},
        Case{"kick={force_n: 1, duration_s: 2}",
             "kick.duration_s: 2 s is 60 periods of the rotor, long for a kick (milliseconds?)"},
        Case{"rotor.damping_ratio=0.5",
             "rotor.damping_ratio: 0.5 of critical damping is much for a rotor (per cent?)"},
        Case{"sweep.speed_hz={from: 60, to: 1200, count: 3}",
             "sweep.speed_hz.to: 1200 Hz is over 20 times the lowest natural frequency (revolutions per "
             "minute?)"},
        Case{"stops.0.clearance_m=0.02",
             "stops.0.clearance_m: 0.02 m is 0.5333 of contact_radius_m (millimetres?)"},
        Case{"stops.0.clearance_m=0.5e-6",
             "stops.0.clearance_m: 5e-07 m is less than a micrometre (millimetres?)"},
        Case{
            "stops.0.friction={coefficient: 10}",
            "stops.0.friction.coefficient: 10 is more friction than surfaces have that slide on (per cent?)"},
        // 2 F T / (pi m w) is 1 mm for 47.4 N and 5 ms.
        Case{"kick={force_n: 2.0e4, duration_s: 0.005}",
             "kick.force_n: 20000 N would move the rotor by 422 clearances (millinewtons?)"},
        Case{"start.x_m=0.5", "start.x_m: 0.5 m is 500 clearances (millimetres?)"}));

class UnitSlipsQuestionOfAKit : public testing::TestWithParam<Case> {};
TEST_P(UnitSlipsQuestionOfAKit, NamesTheUnitThatExplainsTheNumber) {
  EXPECT_EQ(asked(of_kit(GetParam().override), GetParam().override), GetParam().question);
}
INSTANTIATE_TEST_SUITE_P(
    Rules, UnitSlipsQuestionOfAKit,
    testing::Values(
        Case{
            "rotor.shaft.0.density_kg_per_m3=7.85",
            "rotor.shaft.0.density_kg_per_m3: 7.85 kg/m3 is lighter than cork (grams per cubic centimetre?)"},
        Case{"rotor.supports.0.stiffness_x_n_per_m=32",
             "rotor.supports.0.stiffness_x_n_per_m: 32 N/m gives way by more than 10 mm under the weight of "
             "the "
             "rotor (newtons per millimetre?)"},
        Case{"rotor.shaft.0.youngs_modulus_pa=206000",
             "rotor.shaft.0.youngs_modulus_pa: 206000 Pa is softer than rubber (newtons per square "
             "millimetre?)"}));

TEST(UnitSlips, OfAKitAreRefusedAsThoseOfAJeffcottRotor) {
  const auto problem = [](const std::string& override) {
    return message_of(test_file("rotor_kit.yaml"), {override});
  };
  EXPECT_NE(
      problem("sweep.speed_hz={from: 3000, to: 12000, count: 3}")
          .find("sweep.speed_hz.to: 12000 Hz is over 100 times the lowest natural frequency (revolutions per "
                "minute?), allowed: at most "),
      std::string::npos)
      << problem("sweep.speed_hz={from: 3000, to: 12000, count: 3}");
  EXPECT_NE(
      problem("rotor.shaft.0.outer_diameter_m=70")
          .find("rotor.shaft.0.outer_diameter_m: 70 m is no diameter of a shaft (millimetres?), allowed: at "
                "most 20"),
      std::string::npos);
  EXPECT_NE(
      problem("rotor.shaft.0.youngs_modulus_pa=205")
          .find(
              "rotor.shaft.0.youngs_modulus_pa: 205 Pa is softer than any solid (gigapascals?), allowed: at "
              "least 100000"),
      std::string::npos);
  // A kick longer than the run is a different problem.
  EXPECT_NE(message_of(test_file("rotor_kit.yaml"),
                       {"kick={force_n: 1, duration_s: 20}", "response.max_revolutions=100000"})
                .find("periods of the rotor are no kick (milliseconds?)"),
            std::string::npos);
}

TEST(UnitSlips, SeeTwoAxesThatAreSwapped) {
  const std::string swapped =
      "sweep={speed_hz: {from: 0.1, to: 0.9, count: 5}, whirl_ratio: {from: 20, to: 90, count: 5}}";
  const auto all = of_minimal(swapped);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(all.front().ends_with(
      "sweep: speeds up to 0.9 Hz (54 rpm) and whirl ratios up to 90 (the two axes swapped?)"))
      << all.front();
}

TEST(UnitSlips, AskNothingOfPlausibleMachines) {
  EXPECT_TRUE(questions("minimal.yaml", {}).empty());
  EXPECT_TRUE(questions("one_side.yaml", {}).empty());
  EXPECT_TRUE(questions("rotor_kit.yaml", {}).empty());
  EXPECT_TRUE(of_minimal("stops.0.angle_deg=3").empty());
  EXPECT_TRUE(of_kit("rotor.supports.0.stiffness_x_n_per_m=0").empty()) << "a support along y alone";
}

}  // namespace
}  // namespace rubsweep::config
