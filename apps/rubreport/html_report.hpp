#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "rubreport/map_table.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Default limit on the number of cells whose motions a page holds; the page then has about 5 MB.
inline constexpr std::size_t usual_orbits = 4000;

/// Options of a page.
struct PageOptions {
  std::string version;        ///< version of the program
  std::string configuration;  ///< configuration of the study, as YAML
  std::size_t most_orbits =
      usual_orbits;  ///< >= 1; a page of a larger map holds the motions of a thinned grid of cells
  int threads = 0;   ///< 0: one per processor
  batch::Captions captions{};
};

/// Number of cells, at most `most_orbits`, whose motions a page of this map holds.
std::size_t recorded_cells(const sweep::Grid& grid, const page::MapTable& map, std::size_t most_orbits);

/// Page of the finished map `map` of `study`, with the lines of boundaries.csv if `directory` has this file
/// for this map. Cells that a refined map did not compute get the colour of their block. `on_cell` is called
/// after each recorded cell. Empty if `stop` became true before the end. Throws IoError where the map does
/// not have one row for each cell of the study, or boundaries.csv has an error. Throws ConfigError where more
/// than two axes have several values.
std::optional<std::string> report_page(const sweep::Study& study, page::MapTable map,
                                       const std::filesystem::path& directory, const PageOptions& options,
                                       const std::function<void()>& on_cell, const std::atomic<bool>& stop);

}  // namespace rubsweep::apps
