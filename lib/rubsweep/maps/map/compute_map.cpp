#include "rubsweep/maps/map/compute_map.hpp"

#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/map/missing_cells.hpp"

namespace rubsweep::map {

std::optional<report::MapSummary> compute(const config::RunConfig& config,
                                          const std::filesystem::path& directory,
                                          const ComputeOptions& options) {
  MapDirectory map(directory, config, std::nullopt, false, options.program);
  if (map.finished_map()) return map.finished_map()->summary;
  if (MissingCells missing(options, config.study, map); !missing.run()) return std::nullopt;
  const report::MapSummary summary = map.write_map();
  map.paint(config.study.grid);
  return summary;
}

}  // namespace rubsweep::map
