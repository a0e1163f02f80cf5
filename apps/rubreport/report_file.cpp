#include "report_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>

#include "no_report.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/sha256.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/map_of_study.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

std::string interrupted(std::string_view program) {
  return fmt::format("{}: interrupted; {}\n", program, no_report);
}

}  // namespace

int write_report(const fs::path& directory, const sweep::Study& study, std::string_view program,
                 const ReportOptions& options) {
  batch::require_threads(options.threads, 1);
  page::MapTable map = read_map_of(study, directory / "map.csv", program);
  const std::size_t cells = recorded_cells(study.grid, map, options.most_orbits);
  std::mutex mutex;  // guards the progress
  batch::Progress progress(cells, options.quiet ? batch::ProgressMode::never : options.progress);
  const std::atomic<bool>& stop = catch_interrupts();
  const auto refresh = [&] {
    const std::lock_guard lock(mutex);
    progress.refresh();
  };
  const auto leave = [&] {
    const std::lock_guard lock(mutex);
    progress.finish();
    say(interrupted(program));
    std::_Exit(128 + caught_signal());
  };
  std::optional<Watch> watch(std::in_place, refresh, leave);
  const auto count = [&] {
    const std::lock_guard lock(mutex);
    progress.advance();
  };
  const auto text = report_page(study, std::move(map), directory,
                                {.version = RUBSWEEP_VERSION,
                                 .configuration = config::print_study(study),
                                 .most_orbits = options.most_orbits,
                                 .threads = options.threads,
                                 .captions = options.captions},
                                count, stop);
  watch.reset();
  progress.finish();
  if (!text) {
    say(interrupted(program));
    return 128 + caught_signal();
  }
  batch::write_whole_file(options.file, batch::with_page_sum(*text));
  count_in_summary("motions", cells);
  if (!options.quiet)
    print("report: {} ({:.1f} MB)\n", options.file.string(), static_cast<double>(text->size()) / 1e6);
  return done;
}

}  // namespace rubsweep::apps
