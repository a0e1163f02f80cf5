#include "fuzz/whole_path.hpp"

#include <algorithm>
#include <string_view>

#include "explain/explain_study.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::fuzz {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw BrokenContract(what);
}

void check_row(const sweep::Row& row) {
  const std::string line = report::map_line(row), header = report::map_header();
  require(std::count(line.begin(), line.end(), ',') == std::count(header.begin(), header.end(), ','),
          "a row has another number of cells than the header");
  require(!row.status.empty(), "a row has no status");
  require(line.find("nan") == std::string::npos && line.find("inf") == std::string::npos,
          "a row holds a number that is none");
  const bool failed = row.motion_class == response::motion::MotionClass::failed;
  require(!failed || row.status != "ok", "a failed cell does not say why");
  report::MapSummary summary;
  summary.add(line);
  require(summary.has_failed_cells() == failed, "the summary does not see what failed");
}

}  // namespace

Ending check_whole_path(const std::string& text) {
  sweep::Study study;
  try {
    study = config::read_run_config_text(text, "fuzz.yaml", {}).study;
  } catch (const ConfigError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.yaml:"), "a problem has no place");
    return Ending::refused;
  }
  try {
    const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
    require(!apps::explain_study(study).empty(), "nothing is explained");
    response::motion::Workspace workspace;
    check_row(sweep::evaluate_cell(study, prepared, 0, workspace));
  } catch (const ConfigError& error) {
    require(std::string_view(error.what()).find("allowed") != std::string_view::npos,
            "a refusal does not say what is allowed");
    return Ending::no_plan;
  }
  return Ending::evaluated;
}

}  // namespace rubsweep::fuzz
