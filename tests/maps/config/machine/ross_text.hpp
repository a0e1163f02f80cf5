#pragma once

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "maps/batch/temporary_directory.hpp"
#include "maps/config/support.hpp"

namespace rubsweep::config::machine {

/// Text of a shaft element in a small TOML file of ROSS, version 2.
inline std::string ross_shaft(int number, int node, double length_m, double outer_m,
                              const std::string& more = "") {
  return fmt::format(
      "[\"ShaftElement_Shaft Element {0}\"]\nL = {2}\nidl = 0.0\nodl = {3}\nidr = 0.0\nodr = {3}\nn = {1}\n"
      "axial_force = 0\ntorque = 0\nshear_effects = true\nrotary_inertia = true\ngyroscopic = true\n"
      "shear_method_calc = \"cowper\"\ntag = \"Shaft Element {0}\"\n{4}\n"
      "[\"ShaftElement_Shaft Element {0}\".material]\nname = \"steel\"\nrho = 7810.0\nE = 211000000000.0\n"
      "G_s = 81200000000.0\ncolor = \"#525252\"\n\n",
      number, node, length_m, outer_m, more);
}

inline std::string ross_disc(int number, int node, double mass_kg, double polar, double diametral) {
  return fmt::format(
      "[\"DiskElement_Disk {0}\"]\nn = {1}\nm = {2}\nId = {4}\nIp = {3}\ntag = \"Disk {0}\"\nscale_factor = "
      "1.0\n"
      "color = \"Firebrick\"\n\n",
      number, node, mass_kg, polar, diametral);
}

inline std::string ross_bearing(int number, int node, const std::string& numbers) {
  return fmt::format(
      "[\"BearingElement_Bearing {0}\"]\ncolor = \"#355d7a\"\nn = {1}\nscale_factor = 1\n"
      "tag = \"Bearing {0}\"\n{2}\n\n",
      number, node, numbers);
}

/// Equal elements of a shaft of 50 mm diameter.
inline std::string ross_shafts(int count, double length_m) {
  std::string text = "ross_version = \"2.3.0\"\n\n[parameters]\n\n";
  for (int i = 0; i < count; ++i) text += ross_shaft(i, i, length_m, 0.05);
  return text;
}

/// A rotor of three elements on two bearings, which the tests modify.
inline std::string small_ross() {
  return ross_shafts(3, 0.2) + ross_disc(0, 1, 10, 0.1, 0.06) +
         ross_bearing(0, 0, "kxx = [1e6]\ncxx = [100]") + ross_bearing(1, 3, "kxx = [2e6]\ncxx = [50]");
}

/// A configuration with a file of ROSS beside it.
class RossFiles {
 public:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.path() / name, std::ios::binary) << text;
  }

  static std::string yaml(const std::string& name) {
    return "rotor: {kind: ross, file: " + name +
           "}\nstops:\n  - {kind: annular, position_m: 0.2, clearance_m: 1e-4, stiffness_n_per_m: 1e7, "
           "restitution: "
           "0.8, contact_radius_m: 0.025}\nsweep: {speed_hz: {values: [30]}, whirl_ratio: {values: [0.5]}}\n"
           "output: {directory: results}\n";
  }

  RunConfig read(const std::string& text, const std::string& name = "rotor.toml",
                 const std::vector<std::string>& overrides = {}) const {
    write(name, text);
    return read_run_config_text(yaml(name), path("kit.yaml"), overrides);
  }

  model::RotorKit kit(const std::string& text, const std::string& name = "rotor.toml",
                      const std::vector<std::string>& overrides = {}) const {
    const RunConfig config = read(text, name, overrides);
    return *model::kit_of(config.study.machine);
  }

  /// The error message without the directory.
  std::string message(const std::string& text, const std::string& name = "rotor.toml",
                      const std::vector<std::string>& overrides = {}) const {
    write(name, text);
    std::string found = message_of(yaml(name), overrides, path("kit.yaml"));
    const std::string directory = directory_.path().string() + "/";
    for (std::size_t at = found.find(directory); at != std::string::npos; at = found.find(directory))
      found.erase(at, directory.size());
    return found;
  }

 private:
  TemporaryDirectory directory_;
};

}  // namespace rubsweep::config::machine
