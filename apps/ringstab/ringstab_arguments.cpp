#include "ringstab_arguments.hpp"

#include <fmt/format.h>

#include "keys/key_questions.hpp"
#include "rubsweep/ring/read_ring_config.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {
namespace {

po::options_description visible_options() {
  po::options_description options("Options");
  add_output(options, "write there instead of output.directory");
  add_threads(options, "threads of a chart; 0: one per processor");
  add_set(options);
  add_verify(options, "run nothing, say whether the results in a directory are whole and belong together");
  add_key_questions(options);
  add_actions(options, "say what is modelled and how it is solved, run nothing");
  add_progress(options);
  add_last(options);
  return options;
}

}  // namespace

RingstabArguments parse_ringstab_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  if (auto directory = verified_directory_of(given)) {
    RingstabArguments verification;
    verification.verified = std::move(directory);
    verification.quiet = given.count("quiet") != 0;
    return verification;
  }
  if (auto answer = key_answer(given, config::ring::ring_form, "Configuration of ringstab")) {
    RingstabArguments question;
    question.key_answer = std::move(answer);
    return question;
  }
  RingstabArguments arguments{study_arguments(given, "ringstab")};
  if (arguments.action == Action::help || arguments.action == Action::version) return arguments;
  arguments.threads = threads_of(given);
  arguments.progress = progress_of(given);
  return arguments;
}

std::string ringstab_help() {
  return fmt::format(
      "ringstab CONFIG.yaml [options]\n"
      "Stability of rotating loads that rub on an elastic ring: eigenvalues over the speed, onsets, critical "
      "speeds.\n\n"
      "{}\n"
      "Examples:\n"
      "  ringstab configs/ring/figure10.yaml\n"
      "  ringstab configs/ring/figure10.yaml --set friction_coefficient=0 --output /tmp/smooth\n"
      "  ringstab configs/ring/figure10.yaml --set loads.0.inclination_deg=5 --quiet\n"
      "  ringstab configs/ring/figure15.yaml --threads 2         (a stability chart)\n\n"
      "Writes into DIR; speeds in revolutions per minute, loads counted from 0:\n"
      "  eigenvalues.csv      every mode over the speed: real part (positive: unstable) and frequency\n"
      "  onsets.csv           divergence, flutter, coupling, veering and stable windows, with the modes "
      "concerned\n"
      "  critical_speeds.csv  speeds known in closed form beside those found numerically\n"
      "  static_load.csv      with ring.radius_m: steady normal force and slip of every load, where the "
      "model is valid\n"
      "  chart.csv, chart_onsets.csv   with chart: the same over a second parameter\n"
      "  config.yaml          the complete configuration\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 done, but some lines of the chart "
      "failed;\n"
      "7 --verify: not whole; 128+signal when interrupted: finished lines stay in chart.partial.csv.\n",
      text_of(visible_options()));
}

}  // namespace rubsweep::apps
