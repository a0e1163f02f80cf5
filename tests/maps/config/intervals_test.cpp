#include "rubsweep/maps/config/intervals.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "maps/config/support.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {
namespace {

std::string text(std::string_view damping) {
  return fmt::format(
      "rotor: {{kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: {{value: 30, from: 29, to: 31.5}},\n"
      "  damping_ratio: {}}}\n"
      "stops: [{{kind: one_side, angle_deg: 90, clearance_m: 1e-3, stiffness_n_per_m: 2e6, contact_radius_m: "
      "0.01,\n"
      "  restitution: 0.7}}]\n"
      "sweep: {{speed_hz: 60, whirl_ratio: 0.25}}\noutput: {{directory: out}}\n",
      damping);
}

std::string fault(std::string_view damping) {
  try {
    read_run_config_text(text(damping), "m.yaml", {});
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Intervals, HaveTheKeyOfTheirNumber) {
  const auto intervals = read_intervals(text("{from: 0.01, value: 0.02, to: 0.04}"), "m.yaml");
  ASSERT_EQ(intervals.size(), 2U);
  EXPECT_EQ(intervals[0].key, "rotor.natural_frequency_hz");
  EXPECT_EQ(intervals[0].to, 31.5);
  EXPECT_EQ(intervals[1].key, "rotor.damping_ratio");
  EXPECT_EQ(intervals[1].value, 0.02);
  EXPECT_EQ(intervals[1].from, 0.01);
}

TEST(Intervals, AreTheirValueToAllOtherReaders) {
  const RunConfig config = read_run_config_text(text("{value: 0.02, from: 0.01, to: 0.04}"), "m.yaml", {});
  const auto& rotor = std::get<model::JeffcottRotor>(config.study.machine.rotor);
  EXPECT_EQ(rotor.damping_ratio, 0.02);
  EXPECT_EQ(rotor.natural_frequency_hz, 30);
  EXPECT_EQ(print_config(config).find("from: 0.01"), std::string::npos);
  const RunConfig over = read_run_config_text(text("0.02"), "m.yaml", {"rotor.natural_frequency_hz=40"});
  EXPECT_EQ(std::get<model::JeffcottRotor>(over.study.machine.rotor).natural_frequency_hz, 40);
}

TEST(Intervals, WrongOnesAreNamedWithTheirPlace) {
  const std::string where = "m.yaml:2:18: rotor.damping_ratio: ";
  EXPECT_EQ(fault("{value: 0.02, from: 0.01}"),
            where + "is no interval, allowed: {value: V, from: A, to: B} with three numbers");
  EXPECT_EQ(fault("{value: 0.02, from: 0.01, to: x}"), fault("{value: 0.02, from: 0.01}"));
  EXPECT_EQ(fault("{value: 0.02, from: 0.01, to: 0.04, low: 1}"), fault("{value: 0.02, from: 0.01}"));
  EXPECT_EQ(fault("{value: 0.05, from: 0.01, to: 0.04}"),
            where + "does not hold its value, allowed: from <= value <= to, from < to");
  EXPECT_NE(fault("{value: -1, from: -2, to: 0.04}").find("rotor.damping_ratio: -1 is out of range"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::config
