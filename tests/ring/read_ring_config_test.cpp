#include "rubsweep/ring/read_ring_config.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"

namespace rubsweep::config::ring {
namespace {

constexpr const char* text =
    R"(ring: {nodal_diameters: 3, modal_mass_kg: 742, natural_frequency_rad_per_s: 34.4, thickness_ratio: 0.0138}
loads:
  - {kind: spring_mass, angle_deg: 60, mass_kg: 100, radial_stiffness_n_per_m: 1.0e6, tangential_stiffness_n_per_m: 2.0e6}
  - {kind: spring_mass, motion: radial, angle_deg: 70, mass_kg: 0, radial_stiffness_n_per_m: 1.0e6}
  - {kind: spring_mass, motion: tangential, angle_deg: 80, mass_kg: 5, tangential_stiffness_n_per_m: 1.0e6}
  - {kind: beam, angle_deg: -20, inclination_deg: 30, radial_mass_kg: 185.66, flexural_mass_kg: 100,
     radial_stiffness_n_per_m: 1.175e7, tangential_stiffness_n_per_m: 1.0e6}
friction_coefficient: 0.1
speed_rpm: {values: [300, 100, 200]}
chart: {parameter: inclination_deg, load: 3, over: {values: [0, 45]}}
output: {directory: results/x}
)";

std::string problems_of(const std::string& changed, const std::vector<std::string>& overrides = {}) {
  try {
    read_ring_config_text(changed, "ring.yaml", overrides);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReadRingConfig, ReadsEveryKindOfLoad) {
  const RingConfig config = read_ring_config_text(text, "ring.yaml", {});
  const rubsweep::ring::System& system = config.study.system;
  EXPECT_NEAR(3 * rubsweep::ring::critical_speed(system.ring), 34.4, 1e-12);
  ASSERT_EQ(system.loads.size(), 4U);
  EXPECT_EQ(system.loads[0].gyroscopic_mass_kg, 100);
  EXPECT_EQ(system.loads[1].motion, rubsweep::ring::Motion::radial);
  EXPECT_EQ(system.loads[2].flexural_mass_kg, 5);
  EXPECT_EQ(system.loads[3].kind, rubsweep::ring::LoadKind::beam);
  EXPECT_NEAR(system.loads[3].rotary_mass_kg, 15.8, 0.01);
  EXPECT_EQ(config.study.speeds_rpm, (std::vector<double>{100, 200, 300}));
  EXPECT_EQ(config.study.chart->load, 3U);
  EXPECT_EQ(config.output_directory, "results/x");
}

TEST(ReadRingConfig, PrintedReadsBackAsItself) {
  const std::string printed = print_ring_config(read_ring_config_text(text, "ring.yaml", {}));
  EXPECT_EQ(print_ring_config(read_ring_config_text(printed, "printed.yaml", {})), printed);
  EXPECT_NE(printed.find("rotary_mass_kg"), std::string::npos);
}

TEST(ReadRingConfig, GeometryBecomesModalData) {
  const std::string geometry = R"(ring:
  nodal_diameters: 2
  geometry: {radius_m: 1.2, thickness_m: 0.05, width_m: 0.3, density_kg_per_m3: 7800, youngs_modulus_pa: 2.1e11}
loads:
  - kind: beam
    angle_deg: 0
    geometry: {density_kg_per_m3: 7800, section_area_m2: 0.02, second_moment_m4: 4.0e-4, youngs_modulus_pa: 2.1e11}
friction_coefficient: 0
speed_rpm: {from: 0, to: 10, count: 2}
output: {directory: x}
)";
  const rubsweep::ring::System system = read_ring_config_text(geometry, "ring.yaml", {}).study.system;
  EXPECT_NEAR(system.ring.modal_mass_kg, 7800 * 0.3 * 0.05 * 1.2 * 3.14159265358979, 1e-8);
  EXPECT_NEAR(system.loads[0].radial_mass_kg, 7800 * 0.02 * 1.2 / 2, 1e-10);
  const std::string printed = print_ring_config(read_ring_config_text(geometry, "ring.yaml", {}));
  EXPECT_EQ(print_ring_config(read_ring_config_text(printed, "printed.yaml", {})), printed);
}

TEST(ReadRingConfig, DigestKnowsThePhysicsOnly) {
  const auto digest = [](const std::vector<std::string>& overrides) {
    return ring_study_digest(read_ring_config_text(text, "ring.yaml", overrides).study);
  };
  EXPECT_EQ(digest({}), digest({"output.directory=elsewhere"}));
  EXPECT_NE(digest({}), digest({"preload_n=1"}));
}

TEST(ReadRingConfig, AnOverrideTakesBackTheOtherWayToSayIt) {
  EXPECT_EQ(problems_of(text, {"ring.natural_frequency_hz=30"}), "no error");
}

struct Problem {
  std::string from, to, message;
};

class ReadRingConfigProblem : public testing::TestWithParam<Problem> {};

TEST_P(ReadRingConfigProblem, IsSaidWithPlaceAndWhatIsAllowed) {
  EXPECT_EQ(problems_of(replaced(text, GetParam().from, GetParam().to)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    All, ReadRingConfigProblem,
    testing::Values(
        Problem{"nodal_diameters: 3", "nodal_diameters: 1",
                "ring.yaml:1:25: ring.nodal_diameters: 1 is out of range, allowed: an integer from 2 to 100"},
        Problem{
            "thickness_ratio: 0.0138", "thicknes_ratio: 0.0138",
            "ring.yaml:1:7: ring.thickness_ratio: missing, allowed: a number >= 0 and < 1\n"
            "ring.yaml:1:83: ring.thicknes_ratio: unknown key (did you mean 'thickness_ratio'?), allowed: "
            "nodal_diameters, geometry, modal_mass_kg, thickness_ratio, radius_m, modal_stiffness_n_per_m, "
            "natural_frequency_hz, natural_frequency_rad_per_s"},
        Problem{"kind: beam", "kind: bean",
                "ring.yaml:6:12: loads.3.kind: 'bean' is unknown (did you mean 'beam'?), allowed: "
                "spring_mass, beam"},
        Problem{"angle_deg: 70", "angle_deg: 70, inclination_deg: 5",
                "ring.yaml:4:73: loads.1.inclination_deg: a load with one motion has no inclination, "
                "allowed: 0, or "
                "motion: both"},
        Problem{"flexural_mass_kg: 100", "flexural_mass_kg: 50",
                "ring.yaml:6:97: loads.3.rotary_mass_kg: -34.200692 kg belong to these masses, allowed: from "
                "0 to below "
                "flexural_mass_kg"},
        Problem{"[300, 100, 200]", "[300, 1e9]",
                "ring.yaml:9:27: speed_rpm.values.1: 1e9 is out of range, allowed: a number >= 0 and <= "
                "10000000"},
        Problem{"load: 3", "load: 4",
                "ring.yaml:10:43: chart.load: 4 is out of range, allowed: an integer from 0 to 3"},
        Problem{"load: 3", "load: 1",
                "ring.yaml:10:43: chart.parameter: load 1 does not have it by its motion, allowed: a "
                "parameter of loads "
                "that move so"},
        Problem{
            "values: [0, 45]", "values: [0, 95]",
            "ring.yaml:10:65: chart.over.values.1: 95 is out of range, allowed: a number >= -90 and <= 90"}));

TEST(ReadRingConfig, HasCaptionsThatAreNoPartOfTheDigest) {
  const std::string one =
      "title: Ring\nring: {nodal_diameters: 3, modal_mass_kg: 742, natural_frequency_hz: 5, thickness_ratio: "
      "0.01}\n"
      "loads: [{kind: spring_mass, motion: radial, angle_deg: 70, mass_kg: 1, radial_stiffness_n_per_m: "
      "1e6}]\n"
      "friction_coefficient: 0.1\nspeed_rpm: {from: 0, to: 6000, count: 3001}\noutput: {directory: "
      "results}\n";
  const RingConfig config = read_ring_config_text(one, "ring.yaml", {});
  EXPECT_EQ(config.captions.title, "Ring");
  const std::string printed = print_ring_config(config);
  EXPECT_NE(printed.find("speed_rpm:\n  from: 0\n  to: 6000\n  count: 3001\n"), std::string::npos) << printed;
  const RingConfig again = read_ring_config_text(printed, "printed.yaml", {});
  EXPECT_EQ(again.captions, config.captions);
  EXPECT_EQ(again.study.speeds_rpm, config.study.speeds_rpm);
  EXPECT_EQ(ring_study_digest(again.study), ring_study_digest(config.study));
}

TEST(ReadRingConfig, AsksWhetherAUnitSlipped) {
  const std::string one =
      "ring: {nodal_diameters: 3, geometry: {radius_m: 0.5, thickness_m: 0.01, width_m: 0.1,\n"
      "  density_kg_per_m3: 7.8, youngs_modulus_pa: 2.1e11}}\n"
      "loads: [{kind: spring_mass, motion: radial, angle_deg: 1.0472, mass_kg: 1, radial_stiffness_n_per_m: "
      "1e6}]\n"
      "friction_coefficient: 0.1\nspeed_rpm: 100\noutput: {directory: results}\n";
  EXPECT_EQ(
      read_ring_config_text(one, "ring.yaml", {}).questions,
      (std::vector<std::string>{
          "ring.yaml:2:22: ring.geometry.density_kg_per_m3: 7.8 kg/m3 is lighter than cork (grams per cubic "
          "centimetre?)",
          "ring.yaml:3:56: loads.0.angle_deg: 1.0472 degrees is 0.3333 pi (radians?)"}));
}

TEST(ReadRingConfig, HasABase) {
  const TemporaryDirectory directory;
  const std::string one =
      "ring: {nodal_diameters: 3, modal_mass_kg: 742, natural_frequency_rad_per_s: 34.4, thickness_ratio: "
      "0.0138}\n"
      "loads:\n  - {kind: spring_mass, angle_deg: 60, mass_kg: 100, radial_stiffness_n_per_m: 1.0e6, "
      "tangential_stiffness_n_per_m: 2.0e6}\n"
      "friction_coefficient: 0.1\nspeed_rpm: {from: 1, to: 3, count: 3}\noutput: {directory: x}\n";
  std::ofstream(directory.path() / "ring.yaml") << one;
  std::ofstream(directory.path() / "mine.yaml")
      << "base: ring.yaml\nfriction_coefficient: 0.2\nspeed_rpm: {values: [5]}\n"
         "ring: {modal_stiffness_n_per_m: 8.0e5}\n";
  const RingConfig merged = read_ring_config(directory.path() / "mine.yaml", {});
  EXPECT_EQ(merged.study.system.friction_coefficient, 0.2);
  EXPECT_EQ(merged.study.speeds_rpm, std::vector<double>{5});
  EXPECT_EQ(merged.study.system.ring.modal_stiffness_n_per_m, 8.0e5);
  const RingConfig single = read_ring_config_text(print_ring_config(merged), "printed.yaml", {});
  EXPECT_EQ(ring_study_digest(single.study), ring_study_digest(merged.study));
}

}  // namespace

}  // namespace rubsweep::config::ring
