#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "maps/batch/read_whole_file.hpp"
#include "maps/batch/temporary_directory.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::map {

/// A map of four cells, none of which is computed; tests write their content.
struct SmallMap {
  TemporaryDirectory temporary;
  std::filesystem::path path = temporary.path() / "map";

  static config::RunConfig config(const std::vector<std::string>& overrides = {}) {
    return config::read_run_config_text(R"(
rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02}
stops:
  - {kind: one_side, angle_deg: 90, clearance_m: 0.001, stiffness_n_per_m: 2.0e6, contact_radius_m: 0.0375,
     restitution: 0.7}
sweep: {speed_hz: {values: [60, 70]}, whirl_ratio: {values: [0.25, 0.5]}}
output: {directory: results}
)",
                                        "small.yaml", overrides);
  }

  /// Overrides that turn the map into a refined one with 25 cells.
  static std::vector<std::string> refined() {
    return {
        "sweep={speed_hz: {from: 60, to: 100, count: 5}, "
        "whirl_ratio: {from: 0.1, to: 0.5, count: 5}, refine: {levels: 1}}"};
  }

  /// The text of a table as written by a version without checksums.
  static std::string without_checksum(std::string table) {
    for (const std::string_view line : {"# format ", "# sha256 "}) {
      const std::size_t at = table.find(line);
      if (at != std::string::npos) table.erase(at, table.find('\n', at) + 1 - at);
    }
    return table;
  }

  /// Replaces the rows of the complete map, and removes its checksum.
  void give_rows(const std::vector<std::string>& rows) const {
    const std::string table = without_checksum(batch::read_whole_file(path / "map.csv"));
    const std::size_t header = table.find("\nspeed_hz") + 1;
    std::ofstream changed(path / "map.csv");
    changed << table.substr(0, table.find('\n', header) + 1);
    for (const std::string& row : rows) changed << row << '\n';
  }

  MapDirectory begin(std::optional<Share> part = std::nullopt, bool fresh = false,
                     const std::vector<std::string>& overrides = {}) const {
    return MapDirectory(path, config(overrides), part, fresh, "test");
  }

  /// The line of a cell with a synchronous motion, or with a subharmonic one of order `order`.
  static std::string line(std::size_t cell, int order = 1) {
    sweep::Row row;
    row.speed_hz = cell % 2 == 0 ? 60 : 70;
    row.whirl_ratio = cell < 2 ? 0.25 : 0.5;
    row.eccentricity_m = 1e-4;
    row.motion_class =
        order == 1 ? response::motion::MotionClass::synchronous : response::motion::MotionClass::subharmonic;
    row.order = order;
    row.revolutions = 100;
    return report::map_line(row, config().study);
  }

  /// Writes the complete map without journals.
  void finish() const {
    const MapDirectory directory = begin();
    for (const std::size_t cell : directory.missing()) directory.journal().append(cell, line(cell));
    directory.write_map();
  }
};

}  // namespace rubsweep::map
