#include "map_outcome.hpp"

#include <fmt/format.h>

#include "exit_code.hpp"
#include "finished_map.hpp"
#include "report_file.hpp"
#include "terminal_map.hpp"

namespace rubsweep::apps {

int report_map(std::string_view program, const RubsweepArguments& arguments,
               const report::MapSummary& summary, const sweep::Study& study, MapDirectory& directory) {
  const bool shown = !arguments.quiet && arguments.progress != batch::ProgressMode::never;
  const TerminalView view =
      shown ? terminal_view(directory.map(), study.grid, arguments.report) : TerminalView{};
  if (!arguments.quiet) fmt::print("{}{}map: {}\n", view.map, summary.text(), directory.map().string());
  if (!arguments.quiet) warn(program, summary);
  if (arguments.figure) {
    arguments.figure->draw("draw_domain_map.py", directory.map(),
                           study.machine.kick ? "Rub domains after a kick" : "Rub domains");
    if (!arguments.quiet) fmt::print("figure: {}\n", arguments.figure->file().string());
  }
  if (arguments.report) {
    const std::filesystem::path place = directory.map().parent_path();
    const int code = write_report(place, study, program,
                                  {.file = place / "report.html",
                                   .threads = arguments.threads,
                                   .progress = arguments.progress,
                                   .quiet = arguments.quiet,
                                   .before_leaving = [&] { directory.leave(); }});
    if (code != done) return code;
  }
  fmt::print("{}", view.next);
  return summary.has_failed_cells() ? some_cells_failed : done;
}

}  // namespace rubsweep::apps
