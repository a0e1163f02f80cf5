#include "experiment.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "exit_code.hpp"
#include "program.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/config/print_config.hpp"
#include "rubsweep/report/experiment.hpp"

namespace rubsweep::apps {
namespace {

report::Experiment perform(const RubtraceArguments& arguments, const scene::Plan& plan) {
  const report::Sampling sampling{.sample_s = arguments.sample_s, .noise_m = arguments.noise_m};
  if (const auto& ramp = arguments.run_up) {
    return report::run_up(plan, ramp->from_hz, ramp->to_hz, ramp->rate_hz_per_s,
                          std::get<scene::Eccentricity>(arguments.unbalance).value_m, sampling);
  }
  if (!plan.machine.kick) throw UsageError("--free-response: the configuration has no kick");
  return report::free_response(plan, arguments.duration_s, sampling);
}

}  // namespace

int run_experiment(const RubtraceArguments& arguments, const config::RunConfig& config,
                   const std::filesystem::path& directory) {
  const scene::Plan plan = scene::make_plan(config.study.machine);
  const report::Experiment experiment = perform(arguments, plan);
  make_directory(directory);
  batch::write_whole_file(directory / "config.yaml", config::print_config(config));
  std::string names = " config.yaml";
  const std::array<std::pair<std::string_view, const std::string*>, 3> files{
      {{"sensors.csv", &experiment.sensors_csv},
       {"bode.csv", &experiment.bode_csv},
       {"identification.csv", &experiment.identification_csv}}};
  for (const auto& [name, text] : files) {
    if (text->empty()) {
      std::filesystem::remove(directory / name);
      continue;
    }
    batch::write_whole_file(directory / name, *text);
    names.append(" ").append(name);
  }
  if (!arguments.quiet) fmt::print("{}files     {}:{}\n", experiment.summary, directory.string(), names);
  return done;
}

}  // namespace rubsweep::apps
