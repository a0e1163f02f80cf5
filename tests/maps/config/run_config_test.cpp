#include "rubsweep/maps/config/run_config.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <random>
#include <set>

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"

namespace rubsweep::config {
namespace {

const std::filesystem::path folder = CONFIG_TEST_DATA;

TEST(RunConfigRead, ReadsEveryKey) {
  const RunConfig config = read_run_config(folder / "one_side.yaml", {});
  const model::Machine& machine = config.study.machine;
  EXPECT_EQ(std::get<model::JeffcottRotor>(machine.rotor).mass_kg, 0.8);
  EXPECT_EQ(std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz, 30);
  EXPECT_EQ(std::get<model::JeffcottRotor>(machine.rotor).damping_ratio, 0.02);
  ASSERT_EQ(machine.stops.size(), 1U);
  const model::Stop& stop = machine.stops[0];
  EXPECT_EQ(std::get<model::OneSideGeometry>(stop.geometry).angle_deg, 90);
  EXPECT_EQ(stop.clearance_m, 1e-3);
  EXPECT_EQ(stop.stiffness_n_per_m, 2e6);
  EXPECT_EQ(std::get<model::NominalRestitution>(stop.damping).value, 0.7);
  EXPECT_EQ(stop.contact_mass_kg, 0.8);
  EXPECT_EQ(stop.contact_radius_m, 0.0375);
  EXPECT_EQ(std::get<model::StribeckFriction>(stop.friction).gamma,
            (std::array<double, 6>{0, 0, 0, 0.1, 100, 0}));
  ASSERT_TRUE(stop.casing);
  EXPECT_EQ(stop.casing->mass_kg, 0.05);
  EXPECT_EQ(stop.casing->stiffness_n_per_m, 5e5);
  EXPECT_EQ(stop.casing->damping_ratio, 0.1);
  ASSERT_TRUE(machine.kick);
  EXPECT_EQ(machine.kick->force_n, 200);
  EXPECT_EQ(machine.kick->duration_s, 0.005);
  EXPECT_EQ(machine.kick->angle_deg, std::nullopt);
  EXPECT_EQ(machine.gravity_m_per_s2, 0);
  EXPECT_EQ(config.study.grid.speed_hz.size(), 66U);
  EXPECT_EQ(config.study.grid.measure, sweep::UnbalanceMeasure::whirl_ratio);
  EXPECT_EQ(config.study.grid.unbalance.size(), 20U);
  EXPECT_EQ(config.output_directory, "results/one_side");
}

TEST(RunConfigRead, ReadsTheMachineAlone) {
  const std::string text = test_file("one_side.yaml");
  const std::vector<std::string> overrides{"rotor.damping_ratio=0.031", "stops.0.clearance_m=1.2e-3"};
  const model::Machine machine = read_machine_text(text, "text", overrides);
  EXPECT_EQ(std::get<model::JeffcottRotor>(machine.rotor).damping_ratio, 0.031);
  EXPECT_EQ(machine.stops.at(0).clearance_m, 1.2e-3);
  EXPECT_THROW(read_machine_text(text, "text", {"rotor.mass_kg=-1"}), ConfigError);
  EXPECT_THROW(read_machine_text(text, "text", {"rotor.weight=1"}), ConfigError);
}

TEST(RunConfigRead, ReadsEverySolverAndResponseKey) {
  const std::string text =
      test_file("minimal.yaml") +
      "solver: {method: adaptive, stepper: rkf78, contact: smoothed, relative_tolerance: 1e-6,\n"
      "  smoothing_m: 2e-7, max_steps_per_revolution: 5e3}\n"
      "response: {max_revolutions: 200, samples_per_revolution: 64, window_revolutions: 50,\n"
      "  max_order: 7}\n"
      "kick: {force_n: 1, duration_s: 2, angle_deg: -3}\n";
  const RunConfig config = read_run_config_text(text, "text", {});
  EXPECT_EQ(config.study.solver.method, integrate::run::Method::adaptive);
  EXPECT_EQ(config.study.solver.stepper, integrate::run::Stepper::rkf78);
  EXPECT_EQ(config.study.solver.contact, integrate::run::ContactHandling::smoothed);
  EXPECT_EQ(config.study.solver.relative_tolerance, 1e-6);
  EXPECT_EQ(config.study.solver.smoothing_m, 2e-7);
  EXPECT_EQ(config.study.solver.max_steps_per_revolution, 5000);
  EXPECT_EQ(config.study.response.max_revolutions, 200);
  EXPECT_EQ(config.study.response.samples_per_revolution, 64);
  EXPECT_EQ(config.study.response.window_revolutions, 50);
  EXPECT_EQ(config.study.response.max_order, 7);
  EXPECT_EQ(config.study.machine.kick->angle_deg, -3);
}

TEST(RunConfigRead, GivesDefaultsToWhatIsLeftOut) {
  const RunConfig config = read_run_config(folder / "minimal.yaml", {});
  const model::Stop& stop = config.study.machine.stops.at(0);
  EXPECT_EQ(stop.contact_mass_kg, std::nullopt);
  EXPECT_TRUE(std::holds_alternative<model::NoFriction>(stop.friction));
  EXPECT_FALSE(stop.casing);
  EXPECT_FALSE(config.study.machine.kick);
  EXPECT_EQ(config.study.machine.gravity_m_per_s2, 0);
  RunConfig defaults = config;
  defaults.study.solver = {};
  defaults.study.response = {};
  EXPECT_EQ(bits_of(config), bits_of(defaults));
}

TEST(RunConfigRead, TakesEachStepper) {
  for (const std::string word : {"auto", "dopri5", "cash_karp54", "rkf78", "bulirsch_stoer", "rosenbrock4"}) {
    EXPECT_EQ(message_of(test_file("minimal.yaml"), {"solver.stepper=" + word}), "no error");
  }
}

TEST(RunConfigRead, NamesTheFileAsItWasGiven) {
  const std::filesystem::path file = folder / "bad" / "rotor_word.yaml";
  try {
    read_run_config(file, {});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()).find(file.string() + ":1:8: rotor: "), 0U) << error.what();
  }
}

TEST(RunConfigRead, ReportsAFileThatCannotBeRead) {
  try {
    read_run_config(folder / "no_such_file.yaml", {});
    FAIL();
  } catch (const IoError& error) {
    EXPECT_EQ(error.what(),
              (folder / "no_such_file.yaml").string() + ": cannot be read: No such file or directory");
  }
  EXPECT_THROW(read_run_config(folder, {}), IoError);
}

TEST(RunConfigRead, ReportsAllProblemsOfAFileAtOnce) {
  std::string text = test_file("one_side.yaml");
  text = replaced(text, "mass_kg: 0.8", "mass_kg: 0");
  text = replaced(text, "angle_deg: 90", "angle_deg: up");
  text = replaced(text, "casing: {mass_kg: 0.05", "casing: {mas_kg: 0.05");
  text = replaced(text, "count: 66", "count: 1");
  text = replaced(text, "max_order: 12", "max_order: 40");
  text = replaced(text, "output: ", "outputs:");
  EXPECT_EQ(
      message_of(text),
      "test.yaml:2:1: output: missing, allowed: a map\n"
      "test.yaml:4:12: rotor.mass_kg: 0 is out of range, allowed: a number > 0\n"
      "test.yaml:9:16: stops.0.angle_deg: 'up' is not a number, allowed: a finite number\n"
      "test.yaml:16:13: stops.0.casing.mass_kg: missing, allowed: a number > 0\n"
      "test.yaml:16:14: stops.0.casing.mas_kg: unknown key (did you mean 'mass_kg'?), allowed: mass_kg, "
      "stiffness_n_per_m, damping_ratio\n"
      "test.yaml:20:43: sweep.speed_hz.count: 1 value cannot be both from and to, allowed: a count of 2 or "
      "more, "
      "or no to\n"
      "test.yaml:23:98: response.samples_per_revolution: 128 does not resolve max_order, allowed: >= 160 = 4 "
      "max_order\n"
      "test.yaml:23:98: response.max_order: 40 is more than half a window, allowed: <= 32 = "
      "window_revolutions "
      "/ 2\n"
      "test.yaml:24:1: outputs: unknown key (did you mean 'output'?), allowed: base, rotor, stops, kick, "
      "start, "
      "gravity_m_per_s2, sweep, study, solver, response, output, title, author, note");
}

/// The text after one to four random edits: a byte changed, inserted or removed, a part doubled or removed.
std::string mutated(std::string text, std::mt19937_64& random) {
  static const std::string likely = "\n\n  :-,[]{}&*!|>'\"%#?0123456789.eE~\t\r";
  const std::size_t edits = 1 + random() % 4;
  for (std::size_t i = 0; i < edits && !text.empty(); ++i) {
    const std::size_t at = random() % text.size();
    const std::size_t length = 1 + random() % 40;
    const char byte =
        random() % 4 == 0 ? static_cast<char>(random() % 256) : likely[random() % likely.size()];
    switch (random() % 5) {
      case 0: text[at] = byte; break;
      case 1: text.insert(at, 1, byte); break;
      case 2: text.erase(at, 1); break;
      case 3: text.insert(random() % text.size(), text.substr(at, length)); break;
      default: text.erase(at, length);
    }
  }
  return text;
}

TEST(RunConfigRead, AnswersAnyFileWithAConfigurationOrAMessage) {
  const std::string good = test_file("one_side.yaml");
  std::mt19937_64 random(7);
  int taken = 0;
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutated(good, random);
    try {
      read_run_config_text(text, "mutated.yaml", {});
      ++taken;
    } catch (const ConfigError& error) {
      EXPECT_EQ(std::string(error.what()).find("mutated.yaml:"), 0U) << error.what();
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(taken, 50);
  EXPECT_GT(refused, 1000);
}

void for_each_choice(const keys::Form& form, const std::function<void(const keys::Choice&)>& see) {
  for (const keys::Choice& choice : form.choices) see(choice);
  for (const keys::Form& inner : form.forms) for_each_choice(inner, see);
  for (const keys::Key& key : form.keys) for_each_choice(key.form, see);
}

TEST(RunConfigReadForm, AKeyWrittenOverAMapTakesBackTheOtherWays) {
  int choices = 0;
  for_each_choice(run_form(), [&](const keys::Choice& choice) {
    ++choices;
    for (const keys::Way& way : choice.ways) {
      for (const keys::Way& other : choice.ways) {
        for (const std::string& key : other.required) {
          if (std::ranges::count(way.required, key) + std::ranges::count(way.optional, key) > 0) continue;
          yaml::Node map{yaml::Node::Kind::map, yaml::SourcePosition{}};
          map.keys.push_back({key, yaml::SourcePosition{}});
          map.items.push_back(yaml::Node{yaml::Node::Kind::null, yaml::SourcePosition{}});
          const bool shared = std::ranges::any_of(choice.ways, [&](const keys::Way& both) {
            return std::ranges::count(both.required, way.required[0]) > 0 &&
                   std::ranges::count(both.required, key) + std::ranges::count(both.optional, key) > 0;
          });
          run_alternatives().drop(map, way.required[0]);
          EXPECT_EQ(map.keys.empty(), !shared) << way.required[0] << " over " << key;
        }
      }
    }
  });
  EXPECT_GE(choices, 30);
}

}  // namespace
}  // namespace rubsweep::config
