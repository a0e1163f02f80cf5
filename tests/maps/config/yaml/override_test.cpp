#include "rubsweep/maps/config/yaml/override.hpp"

#include "maps/config/support.hpp"

namespace rubsweep::config::yaml {
namespace {

RunConfig read_with(const std::vector<std::string>& overrides) {
  return read_run_config_text(test_file("minimal.yaml"), "minimal.yaml", overrides);
}

std::string problems_with(const std::vector<std::string>& overrides) {
  return message_of(test_file("minimal.yaml"), overrides, "minimal.yaml");
}

TEST(Override, ReplacesAValue) {
  EXPECT_EQ(std::get<model::JeffcottRotor>(read_with({"rotor.mass_kg=1.5"}).study.machine.rotor).mass_kg,
            1.5);
}

TEST(Override, IndexesListsByNumber) {
  const auto stops = read_with({"stops.0.angle_deg=-90"}).study.machine.stops;
  EXPECT_EQ(std::get<model::OneSideGeometry>(stops[0].geometry).angle_deg, -90);
  EXPECT_EQ(read_with({"sweep.whirl_ratio.values.0=0.25"}).study.grid.unbalance, std::vector<double>{0.25});
}

TEST(Override, CreatesMissingKeysAndTheMapsAboveThem) {
  EXPECT_EQ(read_with({"gravity_m_per_s2=9.81"}).study.machine.gravity_m_per_s2, 9.81);
  EXPECT_EQ(read_with({"stops.0.contact_mass_kg=0.3"}).study.machine.stops[0].contact_mass_kg, 0.3);
  EXPECT_EQ(read_with({"solver.max_steps_per_revolution=2000"}).study.solver.max_steps_per_revolution, 2000);
  const RunConfig config = read_with({"stops.0.friction.coefficient=0.2"});
  EXPECT_EQ(std::get<model::ConstantFriction>(config.study.machine.stops[0].friction).coefficient, 0.2);
}

TEST(Override, TakesBackWhatExcludesIt) {
  const auto file = [](const std::vector<std::string>& overrides) {
    return read_run_config_text(test_file("one_side.yaml"), "one_side.yaml", overrides).study;
  };
  const auto stops = file({"stops.0.friction.coefficient=0.2", "stops.0.damping_ns_per_m=3"}).machine.stops;
  EXPECT_EQ(std::get<model::ConstantFriction>(stops[0].friction).coefficient, 0.2);
  EXPECT_EQ(std::get<model::ExplicitDamping>(stops[0].damping).damping_ns_per_m, 3);
  const auto grid = file({"sweep.speed_hz.values=[70, 80]", "sweep.eccentricity_m={values: [1.0e-5]}"}).grid;
  EXPECT_EQ(grid.speed_hz, (std::vector<double>{70, 80}));
  EXPECT_EQ(grid.measure, sweep::UnbalanceMeasure::eccentricity_m);
  // Overriding a part of a range keeps its other parts.
  EXPECT_EQ(file({"sweep.speed_hz.count=3"}).grid.speed_hz.size(), 3u);
}

TEST(Override, TakesAnyYamlAsValue) {
  const RunConfig config = read_with({"kick={force_n: 200, duration_s: 0.005}",
                                      "sweep.speed_hz={values: [70, 80]}", "output.directory=results/a=b"});
  ASSERT_TRUE(config.study.machine.kick);
  EXPECT_EQ(config.study.machine.kick->force_n, 200);
  EXPECT_EQ(config.study.grid.speed_hz, (std::vector<double>{70, 80}));
  EXPECT_EQ(config.output_directory, "results/a=b");
}

TEST(Override, AppliesInOrder) {
  EXPECT_EQ(
      std::get<model::JeffcottRotor>(read_with({"rotor.mass_kg=2", "rotor.mass_kg=3"}).study.machine.rotor)
          .mass_kg,
      3);
  EXPECT_EQ(read_with({"kick={force_n: 1, duration_s: 1}", "kick.force_n=5"}).study.machine.kick->force_n, 5);
}

TEST(Override, RepairsABadValueOfTheFile) {
  const std::string text = replaced(test_file("minimal.yaml"), "mass_kg: 0.8", "mass_kg: -1");
  EXPECT_NE(message_of(text), "no error");
  EXPECT_EQ(message_of(text, {"rotor.mass_kg=1"}), "no error");
}

TEST(Override, ChangesOneOfTwoAliasedCasings) {
  const std::string stop =
      "kind: one_side, angle_deg: 90, clearance_m: 0.001, stiffness_n_per_m: 1, restitution: 1, "
      "contact_radius_m: 0, casing: ";
  const std::string text = "stops:\n  - {" + stop +
                           "&casing {mass_kg: 1, stiffness_n_per_m: 1, damping_ratio: 0}}\n" + "  - {" +
                           stop + "*casing}\n";
  const std::string machine = test_file("minimal.yaml");
  const std::string config =
      machine.substr(0, machine.find("stops:")) + text + machine.substr(machine.find("sweep:"));
  const auto stops =
      read_run_config_text(config, "two.yaml", {"stops.1.casing.mass_kg=2"}).study.machine.stops;
  EXPECT_EQ(stops[0].casing->mass_kg, 1);
  EXPECT_EQ(stops[1].casing->mass_kg, 2);
}

TEST(Override, NamesItselfAsThePlaceOfABadValue) {
  EXPECT_EQ(problems_with({"rotor.mass_kg=heavy"}),
            "--set rotor.mass_kg=heavy: rotor.mass_kg: 'heavy' is not a number, allowed: a number > 0");
  EXPECT_EQ(problems_with({"stops.0.friction={coefficient: -1}"}),
            "--set stops.0.friction={coefficient: -1}: stops.0.friction.coefficient: -1 is out of range, "
            "allowed: a number >= 0 and <= 10");
  EXPECT_EQ(problems_with({"output.directory="}),
            "--set output.directory=: output.directory: has no value, allowed: a text of 1 to 4096 bytes");
  EXPECT_EQ(problems_with({"response.window_revolutions=400"}),
            "--set response.window_revolutions=400: response.max_revolutions: 600 is less than two windows, "
            "allowed: >= 800 = 2 window_revolutions");
  EXPECT_EQ(problems_with({"kick={force_n: 1, duration_s: 1, force_n: 2}"}),
            "--set kick={force_n: 1, duration_s: 1, force_n: 2}: kick.force_n: given again, allowed: each "
            "key once");
}

TEST(Override, NamesItselfAsThePlaceOfWhatItsMapLacks) {
  EXPECT_EQ(problems_with({"kick.force_n=1"}),
            "--set kick.force_n=1: kick.duration_s: missing, allowed: a number > 0");
}

TEST(Override, RefusesAPathThatLeadsNowhere) {
  EXPECT_EQ(problems_with({"solvr.method=auto"}),
            "--set solvr.method=auto: solvr: unknown key (did you mean 'solver'?), allowed: base, rotor, "
            "stops, kick, start, "
            "gravity_m_per_s2, sweep, study, solver, response, output, title, author, note");
  EXPECT_EQ(problems_with({"rotor.mass_kg.value=1"}),
            "--set rotor.mass_kg.value=1: rotor.mass_kg: is '0.8' and cannot hold 'value', allowed: a map or "
            "a list");
  for (const char* index : {"1", "-1", "first", "0x0", "99999999999999999999999"}) {
    const std::string text = std::string("stops.") + index + ".angle_deg=1";
    EXPECT_EQ(problems_with({text}), "--set " + text + ": stops: the list has no item '" + index +
                                         "', allowed: an index from 0 to 0");
  }
}

TEST(Override, RefusesWhatIsNotKeyAndValue) {
  EXPECT_EQ(problems_with({"rotor.mass_kg"}),
            "--set rotor.mass_kg: there is no '=', allowed: key.path=value");
  const std::string form = " is not a path, allowed: 1 to 32 names or indices joined by dots";
  EXPECT_EQ(problems_with({"=1"}), "--set =1: ''" + form);
  EXPECT_EQ(problems_with({"rotor..mass_kg=1"}), "--set rotor..mass_kg=1: 'rotor..mass_kg'" + form);
  EXPECT_EQ(problems_with({"rotor.=1"}), "--set rotor.=1: 'rotor.'" + form);
  std::string deep = "a";
  for (int i = 0; i < 100'000; ++i) deep += ".a";
  EXPECT_NE(problems_with({deep + "=1"}).find(form), std::string::npos);
}

TEST(Override, RefusesAValueThatIsNotYaml) {
  EXPECT_EQ(problems_with({"kick={force_n: 1"}),
            "--set kick={force_n: 1: kick: not valid YAML: end of map flow not found");
  EXPECT_EQ(problems_with({"output.directory='a"}),
            "--set output.directory='a: output.directory: not valid YAML: a quote is not closed");
  EXPECT_EQ(problems_with({"rotor.kind=\xff"}),
            "--set rotor.kind=\\xff: rotor.kind: byte 0xff is not UTF-8, allowed: UTF-8 text");
}

TEST(Override, ReportsAllOverridesAfterTheFile) {
  const std::string text = replaced(test_file("minimal.yaml"), "mass_kg: 0.8", "mass_kg: -1");
  EXPECT_EQ(message_of(text, {"rotor.damping_ratio=-1", "sweep", "rotor.natural_frequency_hz=0"}),
            "test.yaml:2:34: rotor.mass_kg: -1 is out of range, allowed: a number > 0\n"
            "--set rotor.damping_ratio=-1: rotor.damping_ratio: -1 is out of range, allowed: a number >= 0\n"
            "--set sweep: there is no '=', allowed: key.path=value\n"
            "--set rotor.natural_frequency_hz=0: rotor.natural_frequency_hz: 0 is out of range, "
            "allowed: a number > 0");
}

}  // namespace
}  // namespace rubsweep::config::yaml
