#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "exit_code.hpp"
#include "interrupt.hpp"
#include "program.hpp"
#include "rubsweep/batch/progress.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/config/study_digest.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/report/map_summary.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "rubsweep/sweep/explain_study.hpp"
#include "rubsweep/sweep/run_map.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// Some cells failed, or the whole map is there.
ExitCode verdict(const std::vector<std::optional<sweep::Row>>& rows) {
  for (const auto& row : rows) {
    if (row && row->motion_class == response::MotionClass::failed) return some_cells_failed;
  }
  return done;
}

/// An older map must not stand beside a configuration that it did not come from.
void remove_map_of_another_study(const fs::path& map, const std::string& digest) {
  if (!fs::is_regular_file(map)) return;
  if (batch::read_whole_file(map).find("# digest " + digest + "\n") == std::string::npos) fs::remove(map);
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  const fs::path directory = arguments.output.value_or(config.output_directory);
  make_directory(directory);
  const std::string digest = config::study_digest(config.study);
  const fs::path map = directory / "map.csv";
  batch::write_whole_file(directory / "config.yaml", config::print_config(config));
  remove_map_of_another_study(map, digest);
  const fs::path partial = directory / "map.partial.csv";
  fs::remove(partial);
  batch::LineLog finished(partial);
  finished.append(report::map_comments(RUBSWEEP_VERSION, digest) + report::map_header());

  const std::atomic<bool>& stop = catch_interrupts();
  const batch::ProgressMode mode = arguments.quiet ? batch::ProgressMode::never : arguments.progress;
  batch::Progress progress(sweep::cell_count(config.study.grid), mode);
  const auto rows = sweep::run_map(
      config.study, arguments.threads,
      [&](const sweep::Row& row) {
        finished.append(report::map_line(row));
        progress.advance();
      },
      stop);
  progress.finish();
  if (caught_signal() != 0) {
    fmt::print(stderr, "rubsweep: interrupted; finished cells are in {}\n", partial.string());
    return 128 + caught_signal();
  }
  batch::write_whole_file(map, report::map_csv(RUBSWEEP_VERSION, digest, rows));
  fs::remove(partial);
  if (!arguments.quiet) fmt::print("{}map: {}\n", report::map_summary(rows), map.string());
  return verdict(rows);
}

int act(const RubsweepArguments& arguments) {
  if (arguments.action == Action::help) {
    fmt::print("{}", rubsweep_help());
    return done;
  }
  if (arguments.action == Action::version) {
    fmt::print("rubsweep {}\n", RUBSWEEP_VERSION);
    return done;
  }
  const config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  switch (arguments.action) {
    case Action::check:
      if (!arguments.quiet) {
        fmt::print("{}: ok, {} cells\n", arguments.config.string(), sweep::cell_count(config.study.grid));
      }
      return done;
    case Action::explain:
      fmt::print("{}", sweep::explain(config.study));
      return done;
    case Action::print_config:
      fmt::print("{}", config::print_config(config));
      return done;
    default:
      return run(arguments, config);
  }
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubsweep", [&] { return act(parse_rubsweep_arguments(argc, argv)); });
}
