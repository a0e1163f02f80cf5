#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/label_agreement.hpp"
#include "bench/reference.hpp"
#include "bench/work_precision_report.hpp"
#include "rubbench_arguments.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/place_arguments.hpp"
#include "shared/premises.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> file_names{"config.yaml", "work_precision.csv"};

scene::Place place_at(const sweep::Grid& grid, double speed_hz, double unbalance) {
  return {speed_hz, sweep::unbalance_of(grid, unbalance)};
}

std::vector<scene::Place> places_to_label(const sweep::Grid& grid, const RubbenchArguments& arguments) {
  std::vector<scene::Place> places;
  if (arguments.label_speeds == 0) return places;
  for (const std::size_t u : bench::spread(grid.unbalance.size(), arguments.label_unbalances)) {
    for (const std::size_t s : bench::spread(grid.speed_hz.size(), arguments.label_speeds))
      places.push_back(place_at(grid, grid.speed_hz[s], grid.unbalance[u]));
  }
  return places;
}

/// Cell nearest to the centre of all labelled cells with a lasting rub; where none rubs, of all cells.
scene::Place central_rub(const std::vector<scene::Place>& places,
                         const std::vector<bench::LabelledCell>& cells, std::size_t columns) {
  if (cells.empty()) throw ConfigError("no cell of the sweep can be kicked: nothing to measure");
  const auto distance = [&](const bench::LabelledCell& cell) {
    const bool rubs = row_of(cell.label.motion_class).rubs;
    const auto off_centre = [](std::size_t i, std::size_t n) {
      return (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 0.5;
    };
    return (rubs ? 0 : 10) + std::hypot(off_centre(cell.place % columns, columns),
                                        off_centre(cell.place / columns, places.size() / columns));
  };
  return places[std::min_element(cells.begin(), cells.end(), [&](const auto& a, const auto& b) {
                  return distance(a) < distance(b);
                })->place];
}

/// Scene of a cell to be timed. Throws ConfigError where the cell cannot run.
scene::Scene scene_of(const sweep::Study& study, const scene::Place& place) {
  scene::Cell cell = scene::build_cell(study.machine, place.speed_hz, place.unbalance);
  if (!scene::can_run(cell.start)) {
    throw ConfigError(fmt::format("the cell {} cannot be timed: {}", bench::cell_name(place),
                                  cell.start == scene::Start::initial_contact
                                      ? "static forces press the rotor on the wall"
                                      : "no quiet motion has this unbalance"));
  }
  return std::move(cell.scene);
}

/// Smallest number of turns in which a stable orbit can be proven. The proof has a tight tolerance,
/// independent of that of the run.
constexpr int turns_of_a_proof = 100;

/// Time per revolution of the same stepper on the same cell at its tightest tolerance, in microseconds.
double tightest_us(const std::vector<bench::WorkPrecisionLine>& lines, const bench::WorkPrecisionLine& line) {
  double time_us = *line.measurement.microseconds_per_revolution;
  double tolerance = line.measurement.variant.relative_tolerance.value_or(0);
  for (const bench::WorkPrecisionLine& other : lines) {
    const bench::Variant &a = line.measurement.variant, &b = other.measurement.variant;
    const bool same = other.cell == line.cell && a.method == b.method && a.stepper == b.stepper &&
                      a.contact == b.contact && other.measurement.microseconds_per_revolution;
    if (!same || !b.relative_tolerance || *b.relative_tolerance >= tolerance) continue;
    tolerance = *b.relative_tolerance;
    time_us = *other.measurement.microseconds_per_revolution;
  }
  return time_us;
}

/// Labels by variant name. They are compared over the whole map, not only in the timed cell.
class Labels {
 public:
  Labels(const sweep::Study& study, const std::vector<bench::LabelledCell>& cells, double seconds)
      : study_(study), cells_(cells), seconds_(seconds) {}

  void fill(const std::vector<bench::WorkPrecisionLine>& lines, bench::WorkPrecisionLine& line) {
    const auto& time = line.measurement.microseconds_per_revolution;
    if (cells_.empty() || !time) return;
    const bench::Variant& variant = line.measurement.variant;
    const std::string name = bench::variant_name(variant);
    line.labels_too_slow = *time * study_.response.max_revolutions > 1e6 * seconds_ ||
                           tightest_us(lines, line) * turns_of_a_proof > 1e6 * seconds_;
    if (line.labels_too_slow) return;
    if (!known_.contains(name)) {
      known_[name] = bench::label_agreement(cells_, bench::options_of(variant, study_.solver),
                                            study_.response, seconds_);
    }
    line.labels = known_[name];
  }

 private:
  const sweep::Study& study_;
  const std::vector<bench::LabelledCell>& cells_;
  double seconds_;
  std::map<std::string, bench::LabelAgreement> known_;
};

void say(const RubbenchArguments& arguments, const std::string& text) {
  if (arguments.quiet) return;
  print("{}", text);
  std::fflush(stdout);
}

/// The cells given on the command line, or else the cell in the centre of the rubbing ones.
std::vector<scene::Place> places_to_time(const RubbenchArguments& arguments, const sweep::Grid& grid,
                                         const std::vector<scene::Place>& to_label,
                                         const std::vector<bench::LabelledCell>& labelled) {
  std::vector<scene::Place> places;
  for (const CellArgument& cell : arguments.cells)
    places.push_back(place_at(grid, cell.speed_hz, cell.unbalance));
  if (places.empty())
    places.push_back(central_rub(to_label, labelled, std::min(arguments.label_speeds, grid.speed_hz.size())));
  return places;
}

/// Times every variant on one cell. Returns the sentence about the reference for the errors.
std::string measure_cell(const RubbenchArguments& arguments, const sweep::Study& study,
                         const scene::Place& place, std::vector<bench::WorkPrecisionLine>& lines) {
  const std::string name = bench::cell_name(place);
  const scene::Scene scene = scene_of(study, place);
  const auto reference = bench::reference_section(scene, arguments.work.error_turns, study.solver);
  std::string sentence = bench::reference_sentence(name, reference);
  say(arguments, sentence);
  const auto variants = bench::variants_of(scene, study.solver, arguments.work.turns, arguments.steppers,
                                           arguments.relative_tolerances);
  std::optional<WorkingTime> working(std::in_place, "rubbench", "times " + name, !arguments.quiet);
  auto measurements = bench::measure(scene, study.solver, variants, reference.section, arguments.work);
  working.reset();
  for (bench::Measurement& measurement : measurements) {
    // Without long double, the exact solver is the reference, and its error is its distance from the other
    // solvers.
    if (!reference.long_double && !measurement.variant.stepper && measurement.state_error)
      measurement.state_error = bench::uncertainty(reference);
    lines.push_back({.cell = name, .measurement = measurement, .reference = reference});
  }
  return sentence;
}

void warn(const RubbenchArguments& arguments, const sweep::Study& study) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  if (arguments.cells.empty()) return warn_of_premises("rubbench", study, prepared);
  std::vector<double> speeds_hz;
  for (const CellArgument& cell : arguments.cells) speeds_hz.push_back(cell.speed_hz);
  warn_of_premises_at("rubbench", speeds_hz, study, prepared);
}

int run(const RubbenchArguments& arguments, const config::RunConfig& config) {
  const sweep::Study& study = config.study;
  ask("rubbench", config.questions, arguments.quiet);
  for (const CellArgument& cell : arguments.cells) require_speed("--cell", cell.speed_hz, study.machine);
  if (!arguments.quiet) warn(arguments, study);
  const fs::path directory = results_directory(arguments, config.output_directory, "_bench");
  const ResultDirectory made(directory, file_names);
  end_on_interrupts("nothing was written");
  for (const CellArgument& cell : arguments.cells)
    scene_of(study, place_at(study.grid, cell.speed_hz, cell.unbalance));
  const auto to_label = places_to_label(study.grid, arguments);
  std::optional<WorkingTime> working(std::in_place, "rubbench", "labels cells", !arguments.quiet);
  const auto labelled = bench::reference_labels(study.machine, to_label, study.solver, study.response);
  working.reset();
  const auto places = places_to_time(arguments, study.grid, to_label, labelled);
  if (!to_label.empty())
    say(arguments, fmt::format("labels: {} of {} cells can be kicked\n", labelled.size(), to_label.size()));

  std::string comments = bench::work_precision_comments(arguments.work);
  std::vector<bench::WorkPrecisionLine> lines;
  for (const scene::Place& place : places) comments += "# " + measure_cell(arguments, study, place, lines);
  working.emplace("rubbench", "labels cells by every method", !arguments.quiet);
  Labels labels(study, labelled, arguments.label_seconds);
  for (bench::WorkPrecisionLine& line : lines) labels.fill(lines, line);
  working.reset();
  count_in_summary("measurements", lines.size());

  const InterruptsWait whole_set;
  batch::write_result_files({{file_names[0], config::print_config(config)},
                             {file_names[1], comments + bench::work_precision_csv(lines)}},
                            file_names, directory,
                            {"rubbench", config::study_digest(study), batch::caption_lines(config.captions)});
  say(arguments, fmt::format("{}\nfiles: {}: config.yaml work_precision.csv\n",
                             bench::work_precision_table(lines, arguments.work.turns), directory.string()));
  const bool all_ran = std::all_of(lines.begin(), lines.end(), [](const auto& line) {
    return line.measurement.outcome == integrate::run::Outcome::ok;
  });
  return all_ran ? done : some_cells_failed;
}

int perform(const RubbenchArguments& arguments) {
  if (answered("rubbench", arguments.action, rubbench_help)) return done;
  return run(arguments, config::read_cell_config(arguments.config, arguments.overrides));
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubbench", [&] { return perform(parse_rubbench_arguments(argc, argv)); });
}
