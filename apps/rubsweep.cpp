#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "exit_code.hpp"
#include "interrupt.hpp"
#include "rubsweep/batch/progress.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/config/study_digest.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/report/map_summary.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"
#include "rubsweep/sweep/explain_study.hpp"
#include "rubsweep/sweep/run_map.hpp"
#include "rubsweep_arguments.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

void make_directory(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw IoError(fmt::format("{}: {}", directory.string(), error.message()));
}

/// Some cells failed, or the whole map is there.
ExitCode verdict(const std::vector<std::optional<sweep::Row>>& rows) {
  for (const auto& row : rows) {
    if (row && row->motion_class == response::MotionClass::failed) return some_cells_failed;
  }
  return done;
}

int run(const RubsweepArguments& arguments, const config::RunConfig& config) {
  const fs::path directory = arguments.output.value_or(config.output_directory);
  make_directory(directory);
  const std::string digest = config::study_digest(config.study);
  batch::write_whole_file(directory / "config.yaml", config::print_config(config));
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
  const fs::path map = directory / "map.csv";
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
    case Action::explain: fmt::print("{}", sweep::explain(config.study)); return done;
    case Action::print_config: fmt::print("{}", config::print_config(config)); return done;
    default: return run(arguments, config);
  }
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep;
  const auto complain = [](const std::exception& error) { fmt::print(stderr, "rubsweep: {}\n", error.what()); };
  try {
    return apps::act(apps::parse_rubsweep_arguments(argc, argv));
  } catch (const apps::UsageError& error) {
    fmt::print(stderr, "rubsweep: {}\nTry: rubsweep --help\n", error.what());
    return apps::usage;
  } catch (const ConfigError& error) {
    // Already one line per problem, each with its place.
    fmt::print(stderr, "{}\n", error.what());
    return apps::bad_configuration;
  } catch (const IoError& error) {
    complain(error);
    return apps::input_output;
  } catch (const std::filesystem::filesystem_error& error) {
    complain(error);
    return apps::input_output;
  } catch (const std::exception& error) {
    complain(error);
    return 70;  // a fault of the program itself (sysexits: EX_SOFTWARE)
  }
}
