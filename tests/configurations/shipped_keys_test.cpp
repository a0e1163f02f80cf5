// Every key that a reader accepts is used by a configuration in configs/, so that users find an example of
// each.
#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

#include "maps/config/support.hpp"
#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/ring/read_ring_config.hpp"

namespace rubsweep::config {
namespace {

namespace fs = std::filesystem;
using Paths = std::set<std::string>;

/// Keys that no shipped configuration uses, each with the reason.
const Paths unused{
    "base",                          // used by many, but no longer present after reading
    "ring.modal_stiffness_n_per_m",  // alternative to a natural frequency, which is better known
    "rotor.mass_damping_per_s",      // used by files of ROSS; segments have their own
    // a layer may have the same keys as its segment
    "rotor.shaft.layers.inner_diameter_end_m", "rotor.shaft.layers.mass_damping_per_s",
    "rotor.shaft.layers.outer_diameter_end_m", "rotor.shaft.layers.stiffness_damping_s",
    "rotor.shaft.layers.stiffness_inner_diameter_m", "rotor.shaft.layers.stiffness_outer_diameter_m",
    "rotor.supports.fault.multiple",  // determined by the geometry of the bearing
    "stops.hertz.half_width",         // a second formula, only for comparison with the paper
};

/// Path without indices: stops.0.casing becomes stops.casing, and all axes share one section.
std::string without_numbers(const std::string& path) {
  static constexpr std::array of_axes{"from",   "to",  "count", "scale",  "step",
                                      "values", "key", "keys",  "factors"};
  std::string plain, part;
  for (std::istringstream parts(path); std::getline(parts, part, '.');) {
    if (part.find_first_not_of("0123456789") == std::string::npos) continue;
    plain += (plain.empty() ? "" : ".") + part;
  }
  return std::find(of_axes.begin(), of_axes.end(), part) == of_axes.end() ? plain : "axis." + part;
}

void visit(const yaml::Node& node, const std::string& path,
           const std::function<void(const yaml::Node&, const std::string&)>& see) {
  see(node, path);
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const std::string name = node.kind == yaml::Node::Kind::map ? node.keys[i].text : std::to_string(i);
    visit(node.items[i], path.empty() ? name : path + "." + name, see);
  }
}

std::vector<fs::path> shipped() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(CONFIG_TEST_DATA) / "../../../configs")) {
    // stop.yaml in a folder is included by other configurations.
    if (entry.path().extension() == ".yaml" && entry.path().filename() != "stop.yaml")
      files.push_back(entry.path());
  }
  return files;
}

/// Keys that the reader accepts in each of these maps: its message about an unknown key lists them.
Paths known_in(const std::vector<std::string>& maps, const fs::path& file, bool ring) {
  constexpr std::string_view refusal = ": unknown key, allowed: ";
  std::vector<std::string> overrides;
  for (const std::string& map : maps) overrides.push_back((map.empty() ? "" : map + ".") + "zzz=1");
  std::istringstream lines([&]() -> std::string {
    try {
      ring ? void(ring::read_ring_config(file, overrides)) : void(read_run_config(file, overrides));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }());
  Paths known;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(refusal), path = line.find("=1: ");
    if (at == std::string::npos || path == std::string::npos) continue;
    const std::string unknown = line.substr(path + 4, at - path - 4);
    std::string list = line.substr(at + refusal.size()), key;
    std::erase(list, ' ');
    for (std::istringstream keys(list); std::getline(keys, key, ',');)
      known.insert(without_numbers(unknown.substr(0, unknown.size() - 3) + key));
  }
  return known;
}

TEST(ShippedKeys, AreAllThatThereAre) {
  Paths known, used;
  for (const fs::path& file : shipped()) {
    yaml::Diagnostics diagnostics(file, {});
    const yaml::Node root = parse_config(yaml::read_config_bytes(file), file, "a map", {}, diagnostics);
    diagnostics.throw_if_any();
    std::vector<std::string> maps;
    visit(root, "", [&](const yaml::Node& node, const std::string& path) {
      used.insert(without_numbers(path));
      if (node.kind == yaml::Node::Kind::map && !path.ends_with("casings")) maps.push_back(path);
    });
    known.merge(known_in(maps, file, std::ranges::count(maps, "ring") == 1));
  }
  EXPECT_GT(known.size(), 150U);
  Paths missing;
  std::set_difference(known.begin(), known.end(), used.begin(), used.end(),
                      std::inserter(missing, missing.end()));
  EXPECT_EQ(missing, unused);
}

}  // namespace
}  // namespace rubsweep::config
