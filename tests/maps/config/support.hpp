#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"

namespace rubsweep::config {

inline std::string test_file(const std::string& name) {
  std::ifstream stream(std::string(CONFIG_TEST_DATA) + "/" + name, std::ios::binary);
  EXPECT_TRUE(stream) << name;
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The complete message of the ConfigError; "no error" if the text was accepted.
inline std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {},
                              const std::string& name = "test.yaml") {
  try {
    read_run_config_text(text, name, overrides);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

/// Message of the ConfigError for the rotor kit of rotor_kit.yaml with these overrides.
inline std::string kit_message(const std::vector<std::string>& overrides) {
  return message_of(test_file("rotor_kit.yaml"), overrides, "kit.yaml");
}

/// `text` with the first occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// All numbers of a configuration in a fixed order as bits: alternatives as an index, optional numbers with a
/// flag. This comparison shares no code with the printer.
inline std::vector<std::uint64_t> bits_of(const RunConfig& config) {
  std::vector<std::uint64_t> bits;
  const auto put = [&](double value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); };
  const auto count = [&](auto value) { bits.push_back(static_cast<std::uint64_t>(value)); };
  const auto maybe = [&](const std::optional<double>& value) {
    count(value.has_value());
    put(value.value_or(0));
  };
  const model::Machine& machine = config.study.machine;
  put(std::get<model::JeffcottRotor>(machine.rotor).mass_kg),
      put(std::get<model::JeffcottRotor>(machine.rotor).natural_frequency_hz),
      put(std::get<model::JeffcottRotor>(machine.rotor).damping_ratio);
  count(machine.stops.size());
  for (const model::Stop& stop : machine.stops) {
    count(stop.geometry.index());
    if (const auto* wall = std::get_if<model::OneSideGeometry>(&stop.geometry)) put(wall->angle_deg);
    if (const auto* ring = std::get_if<model::AnnularGeometry>(&stop.geometry)) {
      put(ring->offset_m[0]), put(ring->offset_m[1]);
    }
    put(stop.clearance_m), put(stop.stiffness_n_per_m), put(stop.contact_radius_m);
    count(stop.damping.index());
    if (const auto* law = std::get_if<model::NominalRestitution>(&stop.damping)) put(law->value);
    if (const auto* law = std::get_if<model::DeliveredRestitution>(&stop.damping)) put(law->value);
    if (const auto* law = std::get_if<model::RestitutionByRotorMass>(&stop.damping)) put(law->value);
    if (const auto* law = std::get_if<model::ExplicitDamping>(&stop.damping)) put(law->damping_ns_per_m);
    maybe(stop.contact_mass_kg);
    count(stop.friction.index());
    if (const auto* law = std::get_if<model::ConstantFriction>(&stop.friction)) put(law->coefficient);
    if (const auto* law = std::get_if<model::StribeckFriction>(&stop.friction)) {
      for (const double gamma : law->gamma) put(gamma);
    }
    count(stop.casing.has_value());
    const model::Casing casing = stop.casing.value_or(model::Casing{0, 0, 0});
    put(casing.mass_kg), put(casing.stiffness_n_per_m), put(casing.damping_ratio);
  }
  count(machine.kick.has_value());
  const model::Kick kick = machine.kick.value_or(model::Kick{0, 0, {}});
  put(kick.force_n), put(kick.duration_s), maybe(kick.angle_deg);
  put(machine.gravity_m_per_s2);
  count(config.study.grid.speed_hz.size());
  for (const double speed : config.study.grid.speed_hz) put(speed);
  count(config.study.grid.measure);
  for (const double unbalance : config.study.grid.unbalance) put(unbalance);
  const integrate::run::SolverOptions& solver = config.study.solver;
  count(solver.method), count(solver.stepper), count(solver.contact), put(solver.relative_tolerance);
  put(solver.smoothing_m), count(solver.max_steps_per_revolution);
  const response::motion::ResponseOptions& response = config.study.response;
  count(response.max_revolutions), count(response.samples_per_revolution);
  count(response.window_revolutions), count(response.max_order), count(config.study.robustness);
  return bits;
}

}  // namespace rubsweep::config
