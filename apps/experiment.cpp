#include "experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "exit_code.hpp"
#include "program.hpp"
#include "result_files.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/identify/campbell.hpp"
#include "rubsweep/identify/experiment.hpp"
#include "rubsweep/report/campbell_tables.hpp"
#include "rubsweep/report/experiment_tables.hpp"

namespace rubsweep::apps {
namespace {

/// Every file that an experiment may leave.
constexpr std::array<std::string_view, 7> file_names{
    "config.yaml",  "sensors.csv",         "bode.csv",       "identification.csv",
    "campbell.csv", "critical_speeds.csv", "mode_shapes.csv"};

/// The files of an experiment but its configuration, and what it found, for a terminal.
struct Outcome {
  ResultFiles files;
  std::string summary;
};

Outcome outcome_of(report::ExperimentTables tables) {
  return {{{"sensors.csv", std::move(tables.sensors_csv)},
           {"bode.csv", std::move(tables.bode_csv)},
           {"identification.csv", std::move(tables.identification_csv)}},
          std::move(tables.summary)};
}

Outcome campbell_diagram(const CampbellSpeeds& asked, const model::Machine& machine) {
  std::vector<double> speeds_hz;
  for (int k = 0; k < asked.count; ++k)
    speeds_hz.push_back(asked.from_hz + (asked.to_hz - asked.from_hz) * k / (asked.count - 1));
  report::CampbellTables tables =
      report::tables_of(identify::campbell(identify::free_rotor(machine), speeds_hz, 2 * asked.to_hz));
  return {{{"campbell.csv", std::move(tables.campbell_csv)},
           {"critical_speeds.csv", std::move(tables.critical_speeds_csv)},
           {"mode_shapes.csv", std::move(tables.mode_shapes_csv)}},
          std::move(tables.summary)};
}

Outcome perform(const RubtraceArguments& arguments, const model::Machine& described) {
  const scene::PreparedMachine machine = scene::prepare_machine(described);
  if (arguments.campbell) return campbell_diagram(*arguments.campbell, described);
  const identify::Sampling sampling{.sample_s = arguments.sample_s, .noise_m = arguments.noise_m};
  if (const auto& ramp = arguments.run_up) {
    return outcome_of(report::tables_of(identify::run_up(
        machine, ramp->from_hz, ramp->to_hz, ramp->rate_hz_per_s, ramp->eccentricity_m, sampling)));
  }
  if (!machine.machine.kick) throw UsageError("--free-response: the configuration has no kick");
  return outcome_of(report::tables_of(identify::free_response(machine, arguments.duration_s, sampling)));
}

}  // namespace

int run_experiment(const RubtraceArguments& arguments, const config::RunConfig& config,
                   const std::filesystem::path& directory) {
  auto [files, summary] = perform(arguments, config.study.machine);
  make_directory(directory);
  files.emplace("config.yaml", config::print_config(config));
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  write_result_files(files, file_names, directory);
  if (!arguments.quiet) fmt::print("{}{}", summary, files_line(files, directory));
  if (arguments.figure) {
    arguments.figure->draw("draw_campbell.py", directory, "Campbell diagram");
    if (!arguments.quiet) fmt::print("figure    {}\n", arguments.figure->file().string());
  }
  return done;
}

}  // namespace rubsweep::apps
