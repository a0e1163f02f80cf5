#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "ring_csv.hpp"
#include "ring_summary.hpp"
#include "ringstab_arguments.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/ring/read_ring_config.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/kept_files.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/verdict.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::optional<ring::ChartLine>>;

/// All files that a run may write.
constexpr std::array<std::string_view, 7> file_names{"config.yaml",         "eigenvalues.csv", "onsets.csv",
                                                     "critical_speeds.csv", "static_load.csv", "chart.csv",
                                                     "chart_onsets.csv"};

/// Computes the chart and adds its files; returns false if a signal interrupted it.
bool chart(const RingstabArguments& arguments, const ring::Study& study, const batch::ResultSource& source,
           const fs::path& directory, batch::ResultFiles& files, Lines& lines) {
  const std::string comments = ring_comments();
  const fs::path partial = directory / "chart.partial.csv";
  fs::remove(partial);
  batch::LineLog finished(partial);
  finished.append(batch::growing_table_head(source) + comments + chart_header(*study.chart));
  const batch::ProgressMode mode = arguments.quiet ? batch::ProgressMode::never : arguments.progress;
  batch::Progress progress(study.chart->values.size(), mode);
  const std::atomic<bool>& stop = catch_interrupts();
  std::mutex mutex;  // guards progress and finished lines
  const std::string interrupted =
      fmt::format("ringstab: interrupted; finished lines are in {}\n", partial.string());
  std::optional<Watch> watch(
      std::in_place,
      [&] {
        const std::lock_guard lock(mutex);
        progress.refresh();
      },
      [&] {
        const std::lock_guard lock(mutex);
        progress.finish();
        say(interrupted);
        std::_Exit(128 + caught_signal());
      });
  lines = ring::run_chart(
      study.system, *study.chart, ring::speeds_rad_per_s(study), arguments.threads,
      [&](const ring::ChartLine& line) {
        const std::lock_guard lock(mutex);
        finished.append(chart_rows(study, line));
        progress.advance();
      },
      stop);
  watch.reset();
  progress.finish();
  if (caught_signal() != 0) {
    say(interrupted);
    return false;
  }
  files["chart.csv"] = comments + chart_csv(study, lines);
  files["chart_onsets.csv"] = comments + chart_onsets_csv(study, lines);
  return true;
}

int run(const RingstabArguments& arguments, const config::ring::RingConfig& config) {
  const ring::Study& study = config.study;
  const fs::path directory = arguments.output.value_or(config.output_directory);
  keep_configuration(arguments.config, directory, [&] {
    return config::ring::print_ring_config(config::ring::read_ring_config(arguments.config, {}));
  });
  const ResultDirectory made(directory, file_names);
  end_on_interrupts("nothing was written");
  const batch::ResultSource source{"ringstab", config::ring::ring_study_digest(study),
                                   batch::caption_lines(config.captions)};
  const std::string comments = ring_comments();
  count_in_summary("speeds", study.speeds_rpm.size());
  std::optional<WorkingTime> working(std::in_place, "ringstab", "computes eigenvalues", !arguments.quiet);
  const ring::Analysis analysis = ring::analyse(study.system, ring::speeds_rad_per_s(study));
  batch::ResultFiles files{{"config.yaml", config::ring::print_ring_config(config)},
                           {"eigenvalues.csv", comments + eigenvalues_csv(analysis.track)},
                           {"onsets.csv", comments + onsets_csv(analysis.onsets)},
                           {"critical_speeds.csv", comments + critical_speeds_csv(analysis.critical_speeds)}};
  std::string summary = ring_summary(study, analysis);
  if (study.system.ring.radius_m) {
    const auto loads = static_loads(study);
    files["static_load.csv"] = comments + static_load_csv(study, loads);
    summary += validity_summary(study, loads);
  }
  working.reset();
  Lines lines;
  if (study.chart && !chart(arguments, study, source, directory, files, lines)) return 128 + caught_signal();
  batch::write_result_files(files, file_names, directory, source);
  fs::remove(directory / "chart.partial.csv");
  if (!arguments.quiet) {
    print("{}{}{}", summary, chart_summary(lines), batch::files_line(files, directory));
  }
  count_in_summary("chart_lines", lines.size());
  const bool all_ok =
      std::all_of(lines.begin(), lines.end(), [](const auto& line) { return line->status == "ok"; });
  return all_ok ? done : some_cells_failed;
}

std::string size_of(const ring::Study& study) {
  const std::size_t lines = study.chart ? study.chart->values.size() : 0;
  return fmt::format("{} speeds{}", study.speeds_rpm.size(),
                     lines > 0 ? fmt::format(", chart of {} lines", lines) : "");
}

int verify(const fs::path& directory, bool quiet) {
  const auto read = [](const fs::path& file) -> VerifiedConfiguration {
    return {config::ring::ring_study_digest(config::ring::read_ring_config(file, {}).study)};
  };
  return report_verdict("ringstab", directory, verify_directory(directory, read), quiet);
}

int perform(const RingstabArguments& arguments) {
  if (arguments.verified) return verify(*arguments.verified, arguments.quiet);
  if (answered("ringstab", arguments.action, ringstab_help)) return done;
  if (arguments.key_answer) {
    print("{}", *arguments.key_answer);
    return done;
  }
  const config::ring::RingConfig config =
      config::ring::read_ring_config(arguments.config, arguments.overrides);
  ask("ringstab", config.questions, arguments.quiet);
  return act(arguments, {.size = [&] { return size_of(config.study); },
                         .explanation = [&] { return explain_ring(config.study); },
                         .configuration = [&] { return config::ring::print_ring_config(config); },
                         .run = [&] { return run(arguments, config); }});
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("ringstab", [&] { return perform(parse_ringstab_arguments(argc, argv)); });
}
