#include "rubsweep/maps/config/cell_config.hpp"

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/read_run_config.hpp"

namespace rubsweep::config {

RunConfig read_cell_config(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& said_elsewhere) {
  RunConfig config = read_run_config(file, overrides);
  if (config.study.grid.axes.empty()) return config;
  const LineKeys keys = line_keys(config.study.grid, "", file, overrides, said_elsewhere);
  std::vector<std::string> written = overrides;
  for (const sweep::KeyValue& fixed : keys.fixed)
    written.push_back(fixed.key + "=" + batch::csv_number(fixed.value));
  if (!keys.fixed.empty()) config = read_run_config(file, written);
  config.study.grid.axes.clear();
  config.study.with_keys = {};
  return config;
}

}  // namespace rubsweep::config
