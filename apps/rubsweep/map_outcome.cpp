#include "map_outcome.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "report_program.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/map/earlier_results.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "shared/exit_code.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"
#include "shared/writable.hpp"
#include "terminal_map.hpp"

namespace rubsweep::apps {

void refuse_fading(const RubsweepArguments& arguments, const sweep::Study& study) {
  if (arguments.fade && study.robustness != sweep::Robustness::probability)
    throw ConfigError(
        "--fade: the map has no column robust_share, allowed: with response.robustness probability");
}

void refuse_what_cannot_be_shown(const RubsweepArguments& arguments, const sweep::Study& study,
                                 const std::filesystem::path& directory) {
  if (arguments.report) {
    report::require_plane(study.grid, "a report");
    require_writable(directory / "report.html", true);
    require_report_program();
  }
  if (arguments.figure) report::require_plane(study.grid, "a picture");
}

int report_map(std::string_view program, const RubsweepArguments& arguments,
               const report::MapSummary& summary, const config::RunConfig& config,
               map::MapDirectory& directory) {
  const sweep::Study& study = config.study;
  directory.paint(study.grid);
  if (summary_is_wanted() && summary.cells() > 0) {
    count_in_summary("cells", summary.cells());
    for (const auto& [name, cells] : summary.cells_by_name()) count_in_summary(name, cells);
  }
  const bool shown = !arguments.quiet && arguments.progress != batch::ProgressMode::never;
  const TerminalView view =
      shown ? terminal_view(directory.map(), study.grid, arguments.report) : TerminalView{};
  if (!arguments.quiet) {
    std::fputs(view.map.c_str(), stdout);  // print would replace the colour codes of the map
    print("{}map: {}\n", summary.text(), directory.map().string());
  }
  if (!arguments.quiet) map::warn(program, summary);
  if (arguments.figure) {
    arguments.figure->draw("map", directory.map(),
                           study.machine.kick ? "Rub domains after a kick" : "Rub domains",
                           arguments.fade ? std::vector<std::string>{"--fade"} : std::vector<std::string>{});
    if (!arguments.quiet) print("figure: {}\n", arguments.figure->file().string());
  }
  if (arguments.report) {
    if (const int code = write_report(program, arguments, directory.map().parent_path()); code != done)
      return code;
  }
  print("{}", view.next);
  return summary.has_failed_cells() ? some_cells_failed : done;
}

}  // namespace rubsweep::apps
