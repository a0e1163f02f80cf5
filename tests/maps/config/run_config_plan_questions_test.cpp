#include <filesystem>

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {
namespace {

std::vector<std::string> asked(const std::vector<std::string>& overrides) {
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml", overrides).questions;
}

/// The single question about the overrides, without its place.
std::string of(const std::vector<std::string>& overrides, const std::string& key) {
  const auto all = asked(overrides);
  if (all.size() != 1) return std::to_string(all.size()) + " questions";
  const std::size_t at = all.front().find(": " + key + ": ");
  return at == std::string::npos ? all.front() : all.front().substr(at + key.size() + 4);
}

TEST(RunConfigPlanQuestions, NameThePlaceInTheFile) {
  const auto all = asked({"rotor.natural_frequency_hz=3000", "stops.0.stiffness_n_per_m=1.0e8",
                          "sweep.speed_hz={from: 50, to: 150, count: 3}"});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front(),
            "--set sweep.speed_hz={from: 50, to: 150, count: 3}: sweep.speed_hz: no speed is above 150 Hz "
            "(9000 rpm), "
            "less than "
            "a tenth of the natural frequency (rotor.natural_frequency_hz in revolutions per minute?)");
  const auto in_file = asked({"rotor.natural_frequency_hz=3000", "stops.0.stiffness_n_per_m=1.0e8"});
  ASSERT_EQ(in_file.size(), 1U);
  EXPECT_TRUE(in_file.front().starts_with("test.yaml:")) << in_file.front();
}

TEST(RunConfigPlanQuestions, SpeedsMayBeMultiplesOfTheNaturalFrequency) {
  EXPECT_EQ(
      of({"rotor.natural_frequency_hz=100", "sweep.speed_hz={from: 1, to: 5, count: 5}"}, "sweep.speed_hz"),
      "no speed is above 5 Hz (300 rpm), less than a tenth of the natural frequency (multiples of it?)");
  EXPECT_TRUE(
      asked({"rotor.natural_frequency_hz=100", "sweep.speed_hz={from: 1, to: 10, count: 5}"}).empty());
}

TEST(RunConfigPlanQuestions, AKickThatNoCellTakes) {
  EXPECT_EQ(
      of({"kick={force_n: 100, duration_s: 0.005}", "sweep.whirl_ratio={values: [1, 1.5]}"},
         "sweep.whirl_ratio"),
      "the quiet whirl reaches the wall in every cell, so that the kick is never used (ratios below 1?)");
  EXPECT_TRUE(
      asked({"kick={force_n: 100, duration_s: 0.005}", "sweep.whirl_ratio={values: [0.9, 1.5]}"}).empty());
}

/// The sag g / w^2 is 9.81 / (2 pi 5)^2 = 9.94 mm.
TEST(RunConfigPlanQuestions, ARotorThatSagsOntoAStop) {
  const std::vector<std::string> low{"gravity_m_per_s2=9.81", "rotor.natural_frequency_hz=5",
                                     "sweep.speed_hz={from: 10, to: 50, count: 3}"};
  auto below = low;
  below.emplace_back("stops.0.angle_deg=270");
  EXPECT_TRUE(of(below, "gravity_m_per_s2").starts_with("the rotor sags by 0.00994 m and rests on stop 0, "))
      << of(below, "gravity_m_per_s2");
  auto placed = below;
  placed.emplace_back("start={x_m: 0, y_m: -0.0012, vx_m_per_s: 0, vy_m_per_s: 0}");
  EXPECT_TRUE(asked(placed).empty()) << asked(placed).front();
  auto free = below;
  free.emplace_back("start={x_m: 0, y_m: 0, vx_m_per_s: 0, vy_m_per_s: 0}");
  EXPECT_EQ(asked(free).size(), 1U);
  auto above = low;
  above.emplace_back("stops.0.angle_deg=90");
  EXPECT_TRUE(asked(above).empty());
}

TEST(RunConfigPlanQuestions, ANominalRestitutionThatNoImpactDelivers) {
  EXPECT_TRUE(of({"stops.0.restitution=0.1"}, "stops.0.restitution")
                  .starts_with("0.1 is nominal, and an impact returns 0.3"))
      << of({"stops.0.restitution=0.1"}, "stops.0.restitution");
  EXPECT_TRUE(asked({"stops.0.restitution=0.27"}).empty());
}

TEST(RunConfigPlanQuestions, AreNoneOfShippedConfigurations) {
  namespace fs = std::filesystem;
  int count = 0;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(CONFIG_TEST_DATA) / "../../../configs")) {
    const std::string name = entry.path().filename().string();
    const bool of_ring = name.starts_with("ring_") || entry.path().parent_path().filename() == "ring";
    if (entry.path().extension() != ".yaml" || name == "stop.yaml" || of_ring) continue;
    if (entry.path().parent_path().filename() == "recordings") continue;  // not for rubsweep
    const auto questions = read_run_config(entry.path(), {}).questions;
    EXPECT_TRUE(questions.empty()) << questions.front();
    ++count;
  }
  EXPECT_GT(count, 50);
}

}  // namespace
}  // namespace rubsweep::config
