#include "rubsweep/maps/config/yaml/base.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config::yaml {
namespace {

namespace fs = std::filesystem;

/// A directory of configurations that is removed at the end of the test.
class Base : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((directory / name).parent_path());
    std::ofstream(directory / name, std::ios::binary) << text;
  }

  RunConfig read(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    return read_run_config(directory / name, overrides);
  }

  /// The complete error message without the test's directory.
  std::string message(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    try {
      read(name, overrides);
    } catch (const ConfigError& error) {
      std::string text = error.what();
      const std::string prefix = directory.string() + "/";
      for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
        text.erase(at, prefix.size());
      }
      return text;
    }
    return "no error";
  }

  const TemporaryDirectory temporary;
  const fs::path& directory = temporary.path();
};

TEST_F(Base, GivesEveryKeyThatIsNotOverridden) {
  write("machine.yaml", test_file("one_side.yaml"));
  write("mine.yaml", "base: machine.yaml\nrotor: {damping_ratio: 0.05}\noutput: {directory: mine}\n");
  RunConfig expected = read_run_config_text(test_file("one_side.yaml"), "one_side.yaml", {});
  std::get<model::JeffcottRotor>(expected.study.machine.rotor).damping_ratio = 0.05;
  const RunConfig merged = read("mine.yaml");
  EXPECT_EQ(bits_of(merged), bits_of(expected));
  EXPECT_EQ(merged.output_directory, "mine");
}

TEST_F(Base, MergedAndSingleFileAreTheSameStudy) {
  write("machine.yaml", test_file("one_side.yaml"));
  write("mine.yaml", "base: machine.yaml\nstops: [{base: stop.yaml, angle_deg: 0}]\n");
  write(
      "stop.yaml",
      "kind: one_side\nclearance_m: 1.0e-3\nstiffness_n_per_m: 2.0e6\ncontact_radius_m: 0\nrestitution: 1\n");
  const RunConfig merged = read("mine.yaml");
  const std::string printed = print_config(merged);
  EXPECT_EQ(printed.find("base"), std::string::npos);
  write("elsewhere/printed.yaml", printed);
  const RunConfig single = read("elsewhere/printed.yaml");
  EXPECT_EQ(print_config(single), printed);
  EXPECT_EQ(study_digest(single.study), study_digest(merged.study));
  EXPECT_NE(study_digest(merged.study), study_digest(read("machine.yaml").study));
}

TEST_F(Base, MayHaveABaseAndPathsAreRelativeToTheFileThatNamesThem) {
  write("bases/rotors/machine.yaml", test_file("minimal.yaml"));
  write("bases/kicked.yaml", "base: rotors/machine.yaml\nkick: {force_n: 1, duration_s: 0.005}\n");
  write("maps/mine.yaml", "base: ../bases/kicked.yaml\nkick: {force_n: 7}\n");
  const RunConfig config = read("maps/mine.yaml");
  EXPECT_EQ(config.study.machine.kick->force_n, 7);
  EXPECT_EQ(config.study.machine.kick->duration_s, 0.005);
  EXPECT_EQ(std::get<model::JeffcottRotor>(config.study.machine.rotor).mass_kg, 0.8);
  const std::string absolute = "base: " + (directory / "bases/kicked.yaml").string() + "\n";
  EXPECT_EQ(read_run_config_text(absolute, "anywhere/text", {}).study.machine.kick->force_n, 1);
}

TEST_F(Base, AnyMapMayHaveOne) {
  write("stop.yaml",
        "clearance_m: 1.0e-3\nstiffness_n_per_m: 2.0e6\ncontact_radius_m: 0\nrestitution: 1\n"
        "casing: {mass_kg: 1, stiffness_n_per_m: 5, damping_ratio: 0}\n");
  write("two.yaml",
        "base: machine.yaml\nstops:\n"
        "  - {base: stop.yaml, kind: one_side, angle_deg: 90}\n"
        "  - {base: stop.yaml, kind: annular, casing: {stiffness_n_per_m: 6}}\n");
  write("machine.yaml", test_file("minimal.yaml"));
  const auto stops = read("two.yaml").study.machine.stops;
  ASSERT_EQ(stops.size(), 2U);
  EXPECT_EQ(stops[0].casing->stiffness_n_per_m, 5);
  EXPECT_EQ(stops[1].casing->stiffness_n_per_m, 6);
  EXPECT_EQ(stops[1].casing->mass_kg, 1);
  EXPECT_TRUE(std::holds_alternative<model::AnnularGeometry>(stops[1].geometry));
}

TEST_F(Base, ThatOfAnInnerMapOutranksThatOfTheFile) {
  write("machine.yaml",
        replaced(test_file("minimal.yaml"), "output:", "kick: {force_n: 1, duration_s: 1}\noutput:"));
  write("kick.yaml", "force_n: 2\n");
  write("mine.yaml", "base: machine.yaml\nkick: {base: kick.yaml}\n");
  EXPECT_EQ(read("mine.yaml").study.machine.kick->force_n, 2);
  EXPECT_EQ(read("mine.yaml").study.machine.kick->duration_s, 1);
}

TEST_F(Base, OverridesWorkOnTheMergedResult) {
  write("machine.yaml", test_file("one_side.yaml"));
  write("mine.yaml", "base: machine.yaml\nrotor: {mass_kg: 2}\n");
  const auto machine =
      read("mine.yaml", {"rotor.mass_kg=3", "stops.0.casing.mass_kg=4", "stops.0.friction.coefficient=0.2"})
          .study.machine;
  EXPECT_EQ(std::get<model::JeffcottRotor>(machine.rotor).mass_kg, 3);
  EXPECT_EQ(machine.stops[0].casing->mass_kg, 4);
  EXPECT_EQ(std::get<model::ConstantFriction>(machine.stops[0].friction).coefficient, 0.2);
  EXPECT_EQ(
      message("mine.yaml", {"base=machine.yaml", "rotor.base=x"}),
      "--set base=machine.yaml: base: an override is no file and has no base, allowed: a base named in a "
      "file\n"
      "--set rotor.base=x: rotor.base: unknown key, allowed: kind, mass_kg, natural_frequency_hz, "
      "stiffness_n_per_m, damping_ratio, damping_ns_per_m, rotating_damping_ratio");
}

TEST_F(Base, ProblemsNameTheFileThatWroteThem) {
  write("machine.yaml", replaced(test_file("minimal.yaml"), "mass_kg: 0.8", "mass_kg: -1"));
  write("mine.yaml", "base: machine.yaml\n\nrotor: {damping_ratio: -2}\nkick: {force_n: 1}\n");
  EXPECT_EQ(message("mine.yaml"),
            "machine.yaml:2:34: rotor.mass_kg: -1 is out of range, allowed: a number > 0\n"
            "mine.yaml:3:24: rotor.damping_ratio: -2 is out of range, allowed: a number >= 0\n"
            "mine.yaml:4:7: kick.duration_s: missing, allowed: a number > 0");
}

TEST_F(Base, AFileThatCannotBeHadIsTheProblemOfTheLineThatNamesIt) {
  write("missing.yaml", "rotor: {mass_kg: -1}\nbase: no/such.yaml\n");
  EXPECT_EQ(
      message("missing.yaml"),
      "missing.yaml:2:7: base: 'no/such.yaml' cannot be read: No such file or directory, allowed: a file "
      "to read, named relative to this one");
  write("folder.yaml", "base: .\n");
  EXPECT_EQ(message("folder.yaml"),
            "folder.yaml:1:7: base: '.' is not a file, allowed: a file to read, named relative to this one");
  write("device.yaml", "base: /dev/zero\n");
  EXPECT_NE(message("device.yaml").find("'/dev/zero' is not a file"), std::string::npos);
  write("list.yaml", "base: [a.yaml]\n");
  EXPECT_EQ(message("list.yaml"), "list.yaml:1:7: base: is a list, allowed: a text of 1 to 4096 bytes");
  write("nothing.yaml", "base:\n");
  EXPECT_EQ(message("nothing.yaml"),
            "nothing.yaml:1:1: base: has no value, allowed: a text of 1 to 4096 bytes");
  write("inner.yaml", "base: missing.yaml\n");
  EXPECT_EQ(message("inner.yaml"), message("missing.yaml"));
}

TEST_F(Base, AFileThatIsNoMapIsRefusedAtItsOwnPlace) {
  write("mine.yaml", "base: other.yaml\n");
  write("other.yaml", "\n- 1\n");
  EXPECT_EQ(message("mine.yaml"), "other.yaml:2:1: is a list and no base, allowed: a map");
  write("other.yaml", "# nothing\n");
  EXPECT_EQ(message("mine.yaml"), "other.yaml:1:1: the file is empty and no base, allowed: a map");
  write("other.yaml", "rotor: [1\n");
  EXPECT_NE(message("mine.yaml").find("other.yaml:2:1: not valid YAML"), std::string::npos)
      << message("mine.yaml");
  write("stop.yaml", "stops: [{base: other.yaml}]\n");
  write("other.yaml", "x: !tag 1\n");
  EXPECT_EQ(message("stop.yaml"),
            "other.yaml:1:4: stops.0: the tag '!tag' is not supported, allowed: values without a tag");
}

TEST_F(Base, AFileThatLeadsBackToItselfIsRefusedWhereItDoes) {
  write("self.yaml", "base: ./self.yaml\n");
  EXPECT_EQ(message("self.yaml"),
            "self.yaml:1:7: base: './self.yaml' leads back to itself, allowed: a file that is not based on "
            "this one");
  write("a.yaml", "base: b/b.yaml\n");
  write("b/b.yaml", "kick: {base: ../c.yaml}\n");
  write("c.yaml", "\nbase: a.yaml\n");
  EXPECT_EQ(
      message("a.yaml"),
      "b/../c.yaml:2:7: kick.base: 'a.yaml' leads back to itself, allowed: a file that is not based on this "
      "one");
  // The same file twice on one level is not a cycle.
  write("twice.yaml", "rotor: {base: empty.yaml}\nkick: {base: empty.yaml}\n");
  write("empty.yaml", "{}\n");
  EXPECT_EQ(message("twice.yaml").find("base"), std::string::npos) << message("twice.yaml");
}

TEST_F(Base, BoundsFilesGenerationsAndValues) {
  for (int i = 0; i < 20; ++i) {
    write("chain" + std::to_string(i) + ".yaml", "base: chain" + std::to_string(i + 1) + ".yaml\n");
  }
  EXPECT_NE(
      message("chain0.yaml").find("chain16.yaml:1:7: base: too many bases of bases, allowed: at most 16"),
      std::string::npos)
      << message("chain0.yaml");
  // Sixteen files, each of which names the next one forty times.
  std::string list;
  for (int i = 0; i < 16; ++i) {
    list = "x:\n";
    for (int k = 0; k < 40; ++k) list += "  - {base: bomb" + std::to_string(i + 1) + ".yaml}\n";
    write("bomb" + std::to_string(i) + ".yaml", list);
  }
  write("bomb16.yaml", "{}\n");
  EXPECT_NE(message("bomb0.yaml").find("too many bases, allowed: at most 100 in all"), std::string::npos);
  std::string large = "x: [";
  for (int i = 0; i < 60'000; ++i) large += "1, ";
  write("large.yaml", large + "1]\n");
  write("both.yaml", "rotor: {base: large.yaml}\nkick: {base: large.yaml}\n");
  EXPECT_EQ(message("both.yaml"),
            "both.yaml:2:14: kick.base: too many values, allowed: at most 100000 in all bases");
}

TEST_F(Base, AMisspeltOneIsAnUnknownKey) {
  write("mine.yaml", "bases: machine.yaml\n");
  EXPECT_NE(message("mine.yaml").find("mine.yaml:1:1: bases: unknown key (did you mean 'base'?)"),
            std::string::npos)
      << message("mine.yaml");
}

TEST_F(Base, AnswersAnyPairOfFilesWithAConfigurationOrAMessage) {
  const std::string machine = test_file("one_side.yaml");
  const std::string mine =
      "base: machine.yaml\nrotor: {mass_kg: 2}\nsweep: {speed_hz: {values: [50]}}\nkick: {force_n: 100}\n";
  std::mt19937_64 random(11);
  const std::string likely = "\n :-,[]{}&*!'\"#?01.e";
  const auto mutated = [&](std::string text) {
    for (std::size_t edits = random() % 3; edits > 0; --edits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = likely[random() % likely.size()];
      } else {
        text.insert(at, text.substr(random() % text.size(), random() % 30));
      }
    }
    return text;
  };
  int taken = 0, refused = 0;
  for (int i = 0; i < 400; ++i) {
    write("machine.yaml", mutated(machine));
    write("mine.yaml", mutated(mine));
    const std::string answer = message("mine.yaml");
    ++(answer == "no error" ? taken : refused);
    if (answer != "no error") {
      EXPECT_TRUE(answer.starts_with("mine.yaml:") || answer.starts_with("machine.yaml:")) << answer;
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(taken, 20);
}

}  // namespace
}  // namespace rubsweep::config::yaml
