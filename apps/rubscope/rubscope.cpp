#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rubscope/column_list.hpp"
#include "rubscope/comparison.hpp"
#include "rubscope/followed_line.hpp"
#include "rubscope/scope_tables.hpp"
#include "rubscope_arguments.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/opened_file.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"
#include "rubsweep/measurement/scope/waterfall.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/shown_lengths.hpp"
#include "shared/working_time.hpp"
#include "simulated_motion.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// All files that a run may write.
constexpr std::array<std::string_view, 8> file_names{"turns.csv",    "orbit.csv",     "lines.csv",
                                                     "bode.csv",     "waterfall.csv", "measures.csv",
                                                     "compared.csv", "simulated.csv"};

void add_comparison(const config::RunConfig& config, const CellArgument& cell,
                    const recording::Recording& recording, const scope::Verdict& verdict,
                    const model::ShownLengths& shown, batch::ResultFiles& files, std::string& summary) {
  if (recording.place == recording::Place::casing)
    throw ConfigError("--compare: the recording is one of a casing, allowed: one of the shaft");
  if (!verdict.period)
    throw ConfigError(
        "--compare: the recorded motion repeats after no number of turns, allowed: one that does");
  const SimulatedMotion motion = simulate(config, cell);
  const Comparison comparison = compare(verdict, motion.period_m, motion.turns, recording.plane);
  files["compared.csv"] = comparison_csv(comparison);
  files["simulated.csv"] = simulated_orbit_csv(comparison, motion.turns, recording.plane);
  summary += comparison_summary(comparison, shown);
}

int look(const RubscopeArguments& arguments) {
  end_on_interrupts("nothing was written");
  const fs::path& file = arguments.recording;
  const auto& compared = arguments.compared;
  // The configuration is read first, so that its errors appear before anything is computed.
  const auto config = compared
                          ? std::optional(config::read_cell_config(compared->config, compared->overrides))
                          : std::nullopt;
  if (config) ask("rubscope", config->questions, arguments.quiet);
  const recording::ReadRecording read = recording::read_recording(file, arguments.instrument, followed_turns);
  const recording::Recording& recording = read.recording;
  std::optional<WorkingTime> working(std::in_place, "rubscope", "looks at the recording", !arguments.quiet);
  count_in_summary("turns", static_cast<std::size_t>(recording.turns()));
  const bool changing = recording.turns() >= scope::history_turns && scope::speed_changes(recording);
  if (changing && compared)
    throw ConfigError(file.string() +
                      ": the speed changes, allowed with --compare: a steady one, or from_s and to_s");
  scope::Verdict verdict;
  if (!changing) verdict = scope::judge(recording, arguments.thresholds);
  ScopeTables tables = changing ? tables_of_run(recording, arguments.orders, arguments.shown)
                                : tables_of(recording, verdict, arguments.orders, arguments.shown);
  const ResultDirectory made(arguments.directory, file_names);
  batch::ResultFiles files{{"turns.csv", std::move(tables.turns_csv)},
                           {"bode.csv", std::move(tables.bode_csv)},
                           {"waterfall.csv", std::move(tables.waterfall_csv)},
                           {"measures.csv", std::move(tables.measures_csv)}};
  if (!changing) {
    files["orbit.csv"] = std::move(tables.orbit_csv);
    files["lines.csv"] = std::move(tables.lines_csv);
  }
  if (compared)
    add_comparison(*config, compared->cell, recording, verdict, arguments.shown, files, tables.summary);
  working.reset();
  {
    const InterruptsWait whole_set;
    batch::write_result_files(files, file_names, arguments.directory,
                              {"rubscope", config::digest_of(read.text), {}});
    end_on_interrupts("the files are written");
  }
  if (!arguments.quiet) print("{}{}", tables.summary, batch::files_line(files, arguments.directory));
  draw_and_say(arguments.figure, "scope", arguments.directory, file.filename().string(), arguments.quiet,
               drawn_lengths(arguments.shown, true, true));
  return done;
}

int list_columns(const fs::path& file) {
  const recording::Channels channels = recording::read_recording_file(file, batch::read_input(file));
  print_text(column_list(channels, file.string()));
  return done;
}

int perform(const RubscopeArguments& arguments) {
  if (answered("rubscope", arguments.action, rubscope_help)) return done;
  if (arguments.columns) return list_columns(arguments.recording);
  return look(arguments);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubscope", [&] { return perform(parse_rubscope_arguments(argc, argv)); });
}
