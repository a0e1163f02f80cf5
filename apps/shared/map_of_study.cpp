#include "shared/map_of_study.hpp"

#include <fmt/format.h>

#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/earlier_results.hpp"
#include "rubsweep/maps/report/map_cells.hpp"

namespace rubsweep::apps {

page::MapTable read_map_of(const sweep::Study& study, const std::filesystem::path& path,
                           std::string_view program) {
  map::require_whole_table(program, path);
  const batch::CsvReader file(path);
  const std::string digest = config::study_digest(study), there = report::comment_after(file, "digest ");
  file.column("class");
  if (there == digest) return page::read_map_table(path, study.grid);
  throw ConfigError(
      fmt::format("{}: is no map of this configuration (digest {}, this one has {})\n"
                  "allowed: the map and the config.yaml of one run",
                  path.string(), there.empty() ? "none" : there, digest));
}

}  // namespace rubsweep::apps
