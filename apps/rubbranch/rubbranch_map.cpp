#include "rubbranch_map.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "families_csv.hpp"
#include "rubsweep/analysis/branch/families/attribution.hpp"
#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/analysis/branch/journal/family_journal.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/motion_class.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_files.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/map_of_study.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"
#include "shared/working_time.hpp"
#include "shared/writable.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// Class and order of a cell, which decide its colour in a map.
std::string label_of(const page::MapTable& map, std::size_t cell) {
  std::string label(map.word("class", cell));
  if (const auto order = map.number("order", cell)) label += fmt::format("_{}", *order);
  return label;
}

constexpr std::string_view quiet_label = to_string(response::motion::MotionClass::non_contact);
constexpr std::string_view oval_label = to_string(response::motion::MotionClass::quasi_periodic);

const std::string interrupted =
    "rubbranch: interrupted; what was found is kept, the same command goes on from there\n";

/// Whether a cell has a proven closed orbit: a periodic motion, or an oval of a rotationally symmetric
/// machine.
bool is_followed(const page::MapTable& map, std::size_t cell) {
  const bool closes = map.number("order", cell).has_value() || map.word("class", cell) == oval_label;
  return closes && map.word("proof", cell).starts_with("floquet");
}

/// Configuration of a map over a full grid of speed and unbalance. Throws ConfigError for any other map.
config::RunConfig config_of_map(const fs::path& directory) {
  const fs::path file = directory / "config.yaml";
  config::RunConfig config = config::read_run_config(file, {});
  const sweep::Study& study = config.study;
  if (!study.grid.axes.empty()) {
    throw ConfigError(fmt::format(
        "{}: sweep: has axes over keys, allowed with --map: speed and unbalance only", file.string()));
  }
  if (study.grid.refinement) {
    throw ConfigError(fmt::format(
        "{}: sweep.refine: most cells of a refined map are not computed, allowed with --map: a map "
        "of every cell, without sweep.refine",
        file.string()));
  }
  if (const auto axis = sweep::disordered_axis(study.grid)) {
    throw ConfigError(
        fmt::format("{}: sweep.{}: the values are in no order, allowed with --map: values that "
                    "rise, or fall, all along",
                    file.string(), *axis));
  }
  return config;
}

/// Files in the output directory from which the output is computed: those of the map, if it is in the same
/// directory.
std::vector<std::string> sources_beside(const fs::path& output, const fs::path& directory) {
  std::error_code none;
  if (fs::equivalent(output, directory, none)) return {"map.csv"};
  return {};
}

}  // namespace

int run_on_map(const RubbranchArguments& arguments) {
  batch::require_threads(arguments.threads, 1);
  const fs::path directory = arguments.map;
  const config::RunConfig config = config_of_map(directory);
  const sweep::Study& study = config.study;
  const page::MapTable map = read_map_of(study, directory / "map.csv", "rubbranch");
  std::vector<std::string> labels;
  std::vector<std::size_t> proven;
  for (std::size_t cell = 0; cell < map.rows; ++cell) {
    labels.push_back(label_of(map, cell));
    if (is_followed(map, cell)) proven.push_back(cell);
  }
  const fs::path output = arguments.output.value_or(directory);
  for (const char* name : {"families.csv", "edges.csv", "boundaries.csv", "contradictions.csv"})
    require_writable(output / name, true);
  const std::atomic<bool>& stop = catch_interrupts();
  branch::journal::FamilyJournal journal(output, study, arguments.fresh);
  if (journal.found_before() > 0) {
    say(fmt::format("rubbranch: goes on with {} orbits and ways that were found before\n",
                    journal.found_before()));
  }
  std::optional<Watch> watch(
      std::in_place, [&] { journal.refresh(); },
      [&] {
        journal.leave();
        say(interrupted);
        std::_Exit(128 + caught_signal());
      });
  std::optional<WorkingTime> working(std::in_place, "rubbranch",
                                     fmt::format("follows the families of {} proven cells", proven.size()),
                                     !arguments.quiet);
  const branch::families::Families families =
      branch::families::families_of(study, proven, arguments.threads, stop, journal.records());
  const auto checks =
      branch::families::check_labels(study, labels, families, arguments.threads, stop, journal.records());
  watch.reset();
  working.reset();
  if (stop) {
    say(interrupted);
    return 128 + caught_signal();
  }
  const auto edges = branch::families::attribute(study.grid, labels, families.list,
                                                 branch::families::quiet_cells(study), quiet_label);
  batch::write_result_files(
      {{"families.csv", families_csv(study.grid, families.list)},
       {"edges.csv", edges_csv(study.grid, labels, edges)},
       {"boundaries.csv", boundaries_csv(study.grid, families.list)},
       {"contradictions.csv", contradictions_csv(study.grid, labels, checks)}},
      map::family_files, output,
      {"rubbranch", map.digest, batch::caption_lines(config.captions), sources_beside(output, directory)});
  journal.remove();
  count_in_summary("families", families.list.size());
  if (!arguments.quiet) {
    print("{}{}files     {}: boundaries.csv contradictions.csv edges.csv families.csv\n",
          families_summary(study.grid, families, proven.size(), edges), contradictions_summary(checks),
          output.string());
  }
  return families.not_followed.empty() ? done : some_cells_failed;
}

}  // namespace rubsweep::apps
