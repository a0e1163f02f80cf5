#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "datasheet.hpp"
#include "rubdata_arguments.hpp"
#include "rubsweep/maps/batch/file_lock.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/measurement/dataset/data_set.hpp"
#include "rubsweep/measurement/dataset/data_study.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/run_summary.hpp"

namespace rubsweep::apps {
namespace {

dataset::DataStudy read_study(const RubdataArguments& arguments) {
  dataset::DataStudy study = config::dataset::read_data_study_text(
      config::yaml::read_config_bytes(arguments.config), arguments.config.string());
  if (arguments.output) study.directory = *arguments.output;
  return study;
}

/// Makes the missing recordings; returns false if a signal interrupted it.
bool make_missing(const RubdataArguments& arguments, const dataset::DataStudy& study, dataset::DataSet& set) {
  const std::vector<std::size_t> missing = set.missing();
  if (missing.empty()) return true;
  const auto all = static_cast<std::size_t>(study.recordings);
  const std::atomic<bool>& stop = catch_interrupts();
  std::mutex one_at_a_time;
  batch::Progress progress(all, arguments.quiet ? batch::ProgressMode::never : arguments.progress, stderr,
                           all - missing.size());
  const Watch watch(
      [&] {
        const std::lock_guard lock(one_at_a_time);
        progress.refresh();
      },
      // Recordings take a fraction of a second each, so running ones are always finished.
      [] {});
  return set.make(
      missing, arguments.threads,
      [&] {
        const std::lock_guard lock(one_at_a_time);
        progress.advance();
      },
      stop);
}

int perform(const RubdataArguments& arguments) {
  if (answered("rubdata", arguments.action, rubdata_help)) return done;
  const dataset::DataStudy study = read_study(arguments);
  if (arguments.action == Action::check) {
    if (!arguments.quiet) print("{}: ok, {} recordings\n", arguments.config.string(), study.recordings);
    return done;
  }
  batch::require_threads(arguments.threads, 1);
  const std::string program = fmt::format("rubdata {}", RUBSWEEP_VERSION);
  dataset::DataSet set(study, program);
  if (!set.guards()) say(batch::no_locks("rubdata", study.directory));
  if (!make_missing(arguments, study, set)) {
    say("rubdata: interrupted; finished recordings are kept, the same command goes on\n");
    return 128 + caught_signal();
  }
  set.finish({{"README.md", datasheet(study, program)}, {"instrument.yaml", instrument_yaml(study)}});
  count_in_summary("recordings", static_cast<std::size_t>(study.recordings));
  if (!arguments.quiet) print("{} recordings: {}\n", study.recordings, study.directory.string());
  return done;
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubdata", [&] { return perform(parse_rubdata_arguments(argc, argv)); });
}
