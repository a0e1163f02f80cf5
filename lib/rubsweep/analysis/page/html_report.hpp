#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Default number of cells whose motions a page holds: about 5 MB.
inline constexpr std::size_t usual_orbits = 4000;

/// How a page is made.
struct PageOptions {
  std::string version;        ///< version of the program
  std::string configuration;  ///< configuration of the study, as YAML
  std::size_t most_orbits =
      usual_orbits;  ///< >= 1; of a larger map a thinned grid of cells keeps its motions
  int threads = 0;   ///< 0: one per processor
  batch::Captions captions{};
};

/// How many cells a page of this map records, of which most_orbits at most.
std::size_t recorded_cells(const sweep::Grid& grid, const MapTable& map, std::size_t most_orbits);

/// The page of the finished map `map` of `study`, with the lines of boundaries.csv in `directory` where there
/// is such a file of this map. The cells that a refined map did not compute are painted. `on_cell` follows
/// each recorded cell. Empty when `stop` became true before. Throws IoError where the map has not as many
/// rows as the study has cells, or boundaries.csv is at fault; ConfigError where more than two axes have
/// several values.
std::optional<std::string> report_page(const sweep::Study& study, MapTable map,
                                       const std::filesystem::path& directory, const PageOptions& options,
                                       const std::function<void()>& on_cell, const std::atomic<bool>& stop);

}  // namespace rubsweep::page
