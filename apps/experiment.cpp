#include "experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "exit_code.hpp"
#include "program.hpp"
#include "result_files.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/identify/experiment.hpp"
#include "rubsweep/report/experiment_tables.hpp"

namespace rubsweep::apps {
namespace {

/// Every file that an experiment may leave.
constexpr std::array<std::string_view, 4> file_names{"config.yaml", "sensors.csv", "bode.csv",
                                                     "identification.csv"};

report::ExperimentTables perform(const RubtraceArguments& arguments, const scene::PreparedMachine& machine) {
  const identify::Sampling sampling{.sample_s = arguments.sample_s, .noise_m = arguments.noise_m};
  if (const auto& ramp = arguments.run_up) {
    return report::tables_of(identify::run_up(machine, ramp->from_hz, ramp->to_hz, ramp->rate_hz_per_s,
                                              ramp->eccentricity_m, sampling));
  }
  if (!machine.machine.kick) throw UsageError("--free-response: the configuration has no kick");
  return report::tables_of(identify::free_response(machine, arguments.duration_s, sampling));
}

}  // namespace

int run_experiment(const RubtraceArguments& arguments, const config::RunConfig& config,
                   const std::filesystem::path& directory) {
  const scene::PreparedMachine machine = scene::prepare_machine(config.study.machine);
  const report::ExperimentTables experiment = perform(arguments, machine);
  make_directory(directory);
  ResultFiles files{{"config.yaml", config::print_config(config)},
                    {"sensors.csv", experiment.sensors_csv},
                    {"bode.csv", experiment.bode_csv},
                    {"identification.csv", experiment.identification_csv}};
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  write_result_files(files, file_names, directory);
  if (!arguments.quiet) fmt::print("{}{}", experiment.summary, files_line(files, directory));
  return done;
}

}  // namespace rubsweep::apps
