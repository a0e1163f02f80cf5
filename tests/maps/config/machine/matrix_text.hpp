#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/core/model/shaft_matrices.hpp"
#include "rubsweep/maps/config/machine/matrix_market.hpp"
#include "rubsweep/maps/config/machine/printed_matrices.hpp"

namespace rubsweep::config::machine {

inline const model::ShaftMatrices& matrices_of(const RunConfig& config) {
  return *model::kit_of(config.study.machine)->matrices;
}

inline void expect_same(const model::ShaftMatrices& a, const model::ShaftMatrices& b) {
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.stiffness, b.stiffness);
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.gyroscopic, b.gyroscopic);
  ASSERT_EQ(a.degrees_of_freedom.size(), b.degrees_of_freedom.size());
  for (std::size_t i = 0; i < a.degrees_of_freedom.size(); ++i) {
    const model::DegreeOfFreedom &one = a.degrees_of_freedom[i], &other = b.degrees_of_freedom[i];
    EXPECT_EQ(one.node, other.node);
    EXPECT_EQ(one.direction, other.direction);
    EXPECT_EQ(one.position_m, other.position_m);
    EXPECT_EQ(one.weight_kg, other.weight_kg);
  }
  EXPECT_EQ(a.unbalance_kg, b.unbalance_kg);
}

/// A directory with the files of a matrix rotor and a configuration that reads them; the disc is at 0.5 m.
class MatrixFiles {
 public:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.path() / name, std::ios::binary) << text;
  }

  void write(const model::ShaftMatrices& matrices) const {
    for (const auto& [name, text] : matrix_files(matrices)) write(std::string(name), text);
  }

  /// `overrides`: values that replace parts of the configuration.
  RunConfig read(const std::vector<std::string>& overrides = {}) const {
    return read_run_config_text(yaml(), path("my.yaml"), overrides);
  }

  /// The error message without the directory.
  std::string message(const std::vector<std::string>& overrides = {}) const {
    std::string found = message_of(yaml(), overrides, path("my.yaml"));
    const std::string directory = directory_.path().string() + "/";
    for (std::size_t at = found.find(directory); at != std::string::npos; at = found.find(directory))
      found.erase(at, directory.size());
    return found;
  }

  static std::string yaml() {
    return "rotor:\n  kind: matrices\n  mass: {file: mass.mtx}\n  stiffness: {file: stiffness.mtx}\n"
           "  damping: {file: damping.mtx}\n  gyroscopic: {file: gyroscopic.mtx}\n"
           "  degrees_of_freedom: {file: degrees_of_freedom.csv}\n  unbalance: {file: unbalance.csv}\n"
           "stops:\n  - {kind: annular, position_m: 0.5, clearance_m: 1e-4, stiffness_n_per_m: 1e7, "
           "restitution: 0.8, "
           "contact_radius_m: 0.025}\n"
           "sweep: {speed_hz: {values: [30]}, whirl_ratio: {values: [0.5]}}\noutput: {directory: results}\n";
  }

 private:
  TemporaryDirectory directory_;
};

}  // namespace rubsweep::config::machine
