#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "rubline/line_tables.hpp"
#include "rubline_arguments.hpp"
#include "rubsweep/analysis/line/follow_line.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/map_csv.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> file_names{"config.yaml", "line.csv", "bifurcation.csv",
                                                     "cascade.csv"};

/// The single value of an axis of the sweep, used where the command line gives none.
double only_value(const std::vector<double>& axis, std::string_view option) {
  if (axis.size() == 1) return axis.front();
  throw UsageError(fmt::format("the sweep has {} values for it: the place of the line is needed, {}",
                               axis.size(), option));
}

bool along_unbalance(const RublineArguments& arguments) {
  return arguments.along == "whirl_ratio" || arguments.along == "eccentricity_m";
}

std::vector<double> values_of(const RublineArguments& arguments, const sweep::Grid& grid,
                              const config::LineKeys& keys) {
  if (const auto& asked = arguments.values) return batch::evenly_spaced(asked->from, asked->to, asked->count);
  std::vector<double> values;
  if (arguments.along == "speed_hz") values = grid.speed_hz;
  if (along_unbalance(arguments) && to_string(grid.measure) == arguments.along) values = grid.unbalance;
  for (const double value : keys.along.values) values.push_back(keys.factor * value);
  if (values.empty())
    throw UsageError(fmt::format("the values of {} are needed: --from A --to B", arguments.along));
  std::ranges::sort(values);
  return values;
}

/// Speed and unbalance of the cell at `value` on the line.
scene::Place place_at(const RublineArguments& arguments, const sweep::Grid& grid,
                      const model::Machine& machine, double value) {
  scene::Place place;
  if (arguments.along == "speed_hz") {
    if (value <= 0) throw UsageError("--from: allowed: a speed > 0");
    require_speed("--from and --to", value, machine);
    place.speed_hz = value;
  } else {
    place.speed_hz = arguments.place.speed_hz ? *arguments.place.speed_hz
                                              : only_value(grid.speed_hz, "--speed-hz S or --speed-rpm N");
    require_speed("--speed-hz", place.speed_hz, machine);
  }
  if (along_unbalance(arguments)) {
    if (value < 0) throw UsageError("--from: allowed: an unbalance >= 0");
    place.unbalance = arguments.along == "whirl_ratio" ? scene::Unbalance(scene::WhirlRatio{value})
                                                       : scene::Unbalance(scene::Eccentricity{value});
  } else {
    place.unbalance = arguments.place.has_unbalance()
                          ? unbalance_of(arguments.place, machine)
                          : sweep::unbalance_of(grid, only_value(grid.unbalance, unbalance_options));
  }
  return place;
}

/// The study with these keys changed; its grid stays the same.
sweep::Study with_keys(const sweep::Study& study, const std::vector<sweep::KeyValue>& keys) {
  if (keys.empty()) return study;
  sweep::Study held = study.with_keys(keys);
  held.grid = study.grid;
  return held;
}

/// The study of the cell at `value` on a line that varies a configuration key.
sweep::Study study_at(const RublineArguments& arguments, const sweep::Study& study,
                      const config::LineKeys& keys, double value) {
  std::vector<sweep::KeyValue> held = keys.fixed;
  if (!keys.along.keys.empty()) {
    // If the value lies on the axis, the exact number of the axis is used, so that the cell equals that of
    // the map.
    const auto& own = keys.along.values;
    const auto same = std::ranges::find_if(own, [&](double place) { return keys.factor * place == value; });
    const double at = same == own.end() ? value / keys.factor : *same;
    for (sweep::KeyValue& key : sweep::keys_at(keys.along, at)) held.push_back(std::move(key));
    return with_keys(study, held);
  }
  std::vector<std::string> overrides = arguments.overrides;
  overrides.push_back(fmt::format("{}={}", arguments.along, batch::csv_number(value)));
  return with_keys(config::read_run_config(arguments.config, overrides).study, held);
}

std::vector<line::LineCell> cells_of(const RublineArguments& arguments, const config::RunConfig& config) {
  const bool in_the_map = arguments.along == "speed_hz" || along_unbalance(arguments);
  const sweep::Grid& grid = config.study.grid;
  const config::LineKeys keys =
      config::line_keys(grid, arguments.along, arguments.config, arguments.overrides);
  std::shared_ptr<const sweep::Study> study;
  std::shared_ptr<const scene::PreparedMachine> machine;
  std::vector<line::LineCell> cells;
  for (const double value : values_of(arguments, grid, keys)) {
    if (!in_the_map) {
      study = std::make_shared<sweep::Study>(study_at(arguments, config.study, keys, value));
    } else if (!study) {
      study = std::make_shared<sweep::Study>(with_keys(config.study, keys.fixed));
    }
    if (!in_the_map || !machine)
      machine = std::make_shared<scene::PreparedMachine>(scene::prepare_machine(study->machine));
    cells.push_back({value, study, machine, place_at(arguments, study->grid, study->machine, value)});
  }
  return cells;
}

/// A line during its computation; its finished cells can be written at any time.
class LineRun {
 public:
  LineRun(const RublineArguments& arguments, const config::RunConfig& config)
      : arguments_(arguments),
        config_(config),
        cells_(cells_of(arguments, config)),
        directory_(results_directory(arguments, config.output_directory, "_line")),
        progress_(cells_.size() * arguments.passes.size(),
                  arguments.quiet ? batch::ProgressMode::never : arguments.progress) {}

  int run() {
    batch::require_threads(arguments_.threads, 1);
    const ResultDirectory made(directory_, file_names);
    if (!arguments_.quiet) warn();
    const std::atomic<bool>& stop = catch_interrupts();
    std::optional<Watch> watch(
        std::in_place,
        [this] {
          const std::lock_guard lock(mutex_);
          progress_.refresh();
        },
        [this] { leave(); });
    line::follow_line(
        cells_, arguments_.passes, arguments_.threads,
        [this](line::LinePoint&& point) {
          const std::lock_guard lock(mutex_);
          points_.push_back(std::move(point));
          progress_.advance();
        },
        stop);
    watch.reset();
    progress_.finish();
    write();
    count_in_summary("cells", points_.size());
    if (points_.size() < cells_.size() * arguments_.passes.size()) return interrupted();
    if (!arguments_.quiet)
      print("{}{}", line_summary(points_, cells_), batch::files_line(files_, directory_));
    draw("line", "Bifurcation diagram", arguments_.figure);
    draw("cascade", "Cascade of full spectra", arguments_.cascade_figure);
    const bool failed = std::ranges::any_of(points_, [](const line::LinePoint& point) {
      return point.row.motion_class == response::motion::MotionClass::failed;
    });
    return failed ? some_cells_failed : done;
  }

 private:
  /// Warns about the machines at both ends of the line, at the speeds of all cells.
  void warn() const {
    std::vector<double> speeds_hz;
    for (const line::LineCell& cell : cells_) speeds_hz.push_back(cell.place.speed_hz);
    // A line along a key has the same speed everywhere.
    speeds_hz.erase(std::unique(speeds_hz.begin(), speeds_hz.end()), speeds_hz.end());
    const sweep::Study& study = *cells_.front().study;
    warn_of_premises_at("rubline", speeds_hz, study, *cells_.front().machine);
    if (cells_.back().machine != cells_.front().machine)
      warn_of_premises_at("rubline", speeds_hz, study, *cells_.back().machine);
  }

  void write() {
    std::ranges::sort(points_, {},
                      [](const line::LinePoint& point) { return std::pair(point.pass, point.cell); });
    LineTables tables = tables_of(points_, cells_, arguments_.along);
    files_ = {{"config.yaml", config::print_config(config_)},
              {"line.csv", std::move(tables.line_csv)},
              {"bifurcation.csv", std::move(tables.bifurcation_csv)},
              {"cascade.csv", std::move(tables.cascade_csv)}};
    batch::write_result_files(
        files_, file_names, directory_,
        {"rubsweep", config::study_digest(config_.study), batch::caption_lines(config_.captions)});
  }

  int interrupted() {
    say(fmt::format("rubline: interrupted; {} of {} cells are written\n", points_.size(),
                    cells_.size() * arguments_.passes.size()));
    return 128 + caught_signal();
  }

  /// Ends the process when cells still run half a second after a signal; the finished cells are written.
  void leave() {
    const std::lock_guard lock(mutex_);
    progress_.finish();
    try {
      write();
    } catch (const std::exception& error) {
      say(fmt::format("rubline: {}\n", error.what()));
      std::_Exit(input_output);
    }
    std::_Exit(interrupted());
  }

  void draw(const std::string& picture, std::string_view what, const std::optional<Figure>& figure) const {
    draw_and_say(figure, picture, directory_, fmt::format("{}{}", what, where()), arguments_.quiet);
  }

  /// Description of everything constant along the line: " at 75 Hz (4500 rpm), whirl ratio 0.4".
  std::string where() const {
    const scene::Place& place = cells_.front().place;
    std::string text;
    if (arguments_.along != "speed_hz") text = model::speed_text(place.speed_hz);
    if (!along_unbalance(arguments_)) {
      if (!text.empty()) text += ", ";
      text += std::visit(
          overloaded{
              [](const scene::WhirlRatio& ratio) { return fmt::format("whirl ratio {:.6g}", ratio.value); },
              [](const scene::Eccentricity& eccentricity) {
                return fmt::format("eccentricity {:.6g} mm", 1e3 * eccentricity.value_m);
              }},
          place.unbalance);
    }
    return " at " + text;
  }

  const RublineArguments& arguments_;
  const config::RunConfig& config_;
  const std::vector<line::LineCell> cells_;
  const fs::path directory_;
  std::mutex mutex_;  ///< guards all members below
  batch::Progress progress_;
  std::vector<line::LinePoint> points_;
  batch::ResultFiles files_;
};

int perform(const RublineArguments& arguments) {
  if (answered("rubline", arguments.action, rubline_help)) return done;
  const config::RunConfig config = config::read_run_config(arguments.config, arguments.overrides);
  ask("rubline", config.questions, arguments.quiet);
  if (arguments.place.has_unbalance())
    ask_about("rubline", unbalance_of(arguments.place, config.study.machine), config.study.machine,
              arguments.quiet);
  return LineRun(arguments, config).run();
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubline", [&] { return perform(parse_rubline_arguments(argc, argv)); });
}
