#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "basin_slice.hpp"
#include "rubbasin_arguments.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/map/map_files.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/missing_cells.hpp"
#include "shared/place_arguments.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

std::string axis_of(const StartNumber& number, const StartRange& range, std::size_t count) {
  return fmt::format("{{key: {}, from: {}, to: {}, count: {}}}", number.key, range.from, range.to, count);
}

using Plane = std::array<StartNumber, 2>;

Plane plane_of(const RubbasinArguments& arguments) {
  if (arguments.plane) return *arguments.plane;
  const config::RunConfig config = config::read_cell_config(arguments.config, arguments.overrides);
  return usual_plane(config.study.machine.stops.front());
}

/// Configuration of a map that is the slice: one cell, and an axis for each number of the plane.
config::RunConfig sliced_config(const RubbasinArguments& arguments, const Plane& plane) {
  const config::RunConfig given =
      config::read_cell_config(arguments.config, arguments.overrides, {plane[0].key, plane[1].key});
  ask("rubbasin", given.questions, arguments.quiet);
  ask_about("rubbasin", sweep::unbalance_of(given.study.grid, arguments.cell.unbalance), given.study.machine,
            arguments.quiet);
  require_speed("--cell", arguments.cell.speed_hz, given.study.machine);
  std::array<std::string, 2> axes;
  bool has_state = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const StartNumber& number = plane[i];
    refuse_missing_casing(number, given);
    has_state = has_state || number.is_state;
    const StartRange range = arguments.from ? StartRange{(*arguments.from)[i], (*arguments.to)[i]}
                                            : usual_range(number, given, arguments.cell.speed_hz);
    axes[i] = axis_of(number, range, arguments.starts[i]);
  }
  config::RunConfig plain = given;
  plain.study.threshold.reset();
  plain.study.basin.reset();
  plain.study.robustness = sweep::Robustness::off;
  std::vector<std::string> overrides;  // the list holds the overrides of the command line
  // An initial state in the configuration is kept. Without one, an empty `start` replaces the kick or `rest`.
  const auto& start = given.study.machine.start;
  if (has_state && (!start || start->at_rest)) overrides.emplace_back("start={}");
  overrides.push_back(fmt::format("sweep={{speed_hz: {{values: [{}]}}, {}: {{values: [{}]}}, x: {}, y: {}}}",
                                  arguments.cell.speed_hz, to_string(given.study.grid.measure),
                                  arguments.cell.unbalance, axes[0], axes[1]));
  return config::read_run_config_text(config::print_config(plain), arguments.config, overrides);
}

int write_slice(const RubbasinArguments& arguments, const Plane& plane, const config::RunConfig& config,
                const fs::path& map) {
  const auto& axes = config.study.grid.axes;
  const BasinSlice slice = read_basin_slice(
      map, {{plane[0].column, plane[1].column}, {axes.at(0).values, axes.at(1).values}}, config.study.grid);
  const batch::ResultFiles files{{"slice.csv", report::map_comments() + slice_csv(slice)},
                                 {"attractors.csv", report::map_comments() + attractors_csv(slice)}};
  count_in_summary("starts", sweep::cell_count(config.study.grid));
  const fs::path directory = map.parent_path();
  batch::write_result_files(
      files, map::slice_files, directory,
      {"rubsweep", config::study_digest(config.study), batch::caption_lines(config.captions), {"map.csv"}});
  if (!arguments.quiet) {
    print("{}files     {}: attractors.csv config.yaml map.csv slice.csv\n", slice_summary(slice),
          directory.string());
  }
  if (arguments.figure) {
    const bool by_ratio = config.study.grid.measure == sweep::UnbalanceMeasure::whirl_ratio;
    const double unbalance = arguments.cell.unbalance;
    draw_and_say(arguments.figure, "basin", directory,
                 fmt::format("Basins at {}, {}", model::speed_text(arguments.cell.speed_hz),
                             by_ratio ? fmt::format("whirl ratio {:.6g}", unbalance)
                                      : fmt::format("eccentricity {:.6g} mm", 1e3 * unbalance)),
                 arguments.quiet);
  }
  return slice.basins.failed > 0 ? some_cells_failed : done;
}

int perform(const RubbasinArguments& arguments) {
  if (answered("rubbasin", arguments.action, rubbasin_help)) return done;
  const Plane plane = plane_of(arguments);
  const config::RunConfig config = sliced_config(arguments, plane);
  batch::require_threads(arguments.threads, 1);
  const fs::path output =
      arguments.output.value_or(batch::directory_beside(config.output_directory, "_basin"));
  keep_run_configuration(arguments.config, output);
  map::MapDirectory directory(output, config, std::nullopt, arguments.fresh, "rubbasin");
  if (directory.finished_map()) {
    if (!arguments.quiet) say(map::map_is_there("rubbasin"));
    return write_slice(arguments, plane, config, directory.map());
  }
  const SweepRun how{"rubbasin", arguments.threads, arguments.progress, arguments.quiet};
  if (!compute_missing_cells(how, config.study, directory)) return 128 + caught_signal();
  map::warn("rubbasin", directory.write_map());
  return write_slice(arguments, plane, config, directory.map());
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubbasin", [&] { return perform(parse_rubbasin_arguments(argc, argv)); });
}
