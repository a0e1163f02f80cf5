#include "rubdiagnose_arguments.hpp"

#include <fmt/format.h>

#include <vector>

#include "shared/command_line.hpp"
#include "shared/program.hpp"
#include "shared/shown_lengths.hpp"

namespace rubsweep::apps {
namespace {

po::options_description visible_options() {
  po::options_description options("Options");
  const auto yaml = [] { return po::value<std::string>()->value_name("FILE.yaml"); };
  options.add_options()(
      "machine", yaml(),
      "configuration of the rotor, as rubfit leaves it; parameters.csv beside it has the intervals")(
      "candidates", yaml(),
      "what is asked about, with ranges for what is not known; the usual list unless given");
  add_instrument(options);
  options.add_options()("motions", po::value<int>()->value_name("N")->default_value(600),
                        "simulated motions of each candidate")(
      "rounds", po::value<int>()->value_name("N")->default_value(0),
      "of earlier versions: 160 more motions of each candidate for each round")(
      "seed", po::value<long>()->value_name("N")->default_value(1), "of the random numbers")(
      "table", po::value<std::string>()->value_name("DIR"),
      "keep simulated motions there, for the next recording of the machine at that speed, instead of beside "
      "FILE.yaml of --machine, with the ending _cases");
  add_output(options, "write there instead of into RECORDING without its ending and with _diagnosis");
  add_threads(options, "threads; 0: one per processor");
  add_figure(options, "draw probabilities, orbits and lines");
  add_shown_lengths(options);
  add_progress(options);
  add_last(options);
  return options;
}

int number_of(const po::variables_map& given, const char* name, int least, int most) {
  const int number = given[name].as<int>();
  if (number < least || number > most)
    throw UsageError(fmt::format("--{}: {}, allowed: {} to {}", name, number, least, most));
  return number;
}

}  // namespace

std::string rubdiagnose_help() {
  return fmt::format(
      "rubdiagnose RECORDING --machine MACHINE.yaml [options]\n"
      "Says which rub a recording shows, if any: probabilities of candidates and of none of them, by "
      "comparison with simulated motions of the machine.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubdiagnose run7.csv --machine run7_fit/config.yaml           (with run7.yaml beside the "
      "recording)\n"
      "  rubdiagnose run7.csv --machine kit.yaml --candidates two_screws.yaml --figure run7.png\n\n"
      "Writes into DIR:\n"
      "  diagnosis.json     the answer, with intervals for what was not known\n"
      "  probabilities.csv  of each candidate and of none of these\n"
      "  orbits.csv         the recording and the closest simulated motion\n"
      "  lines.csv          lines of both\n\n"
      "The rotor is a Jeffcott rotor or a rotor kit. It runs steadily, up or down. Ctrl-C gives the answer "
      "of the motions simulated so far.\n\n"
      "Exit codes: 0 done; 1 usage; 2 a recording, machine or list that cannot be used; 3 input/output; "
      "128+signal when interrupted.\n",
      text_of(visible_options()));
}

RubdiagnoseArguments parse_rubdiagnose_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_recording_command_line(argc, argv, visible_options());
  if (action_of(given) == Action::run && (!given.count("recording") || !given.count("machine")))
    throw UsageError("a recording and its machine are needed: rubdiagnose RECORDING --machine MACHINE.yaml");
  RubdiagnoseArguments arguments{
      recording_arguments(given, "rubdiagnose RECORDING --machine MACHINE.yaml", "_diagnosis")};
  if (arguments.action != Action::run) return arguments;
  arguments.machine = arguments.table = given["machine"].as<std::string>();
  arguments.table.replace_extension();
  arguments.table += "_cases";
  if (given.count("candidates")) arguments.candidates = given["candidates"].as<std::string>();
  if (given.count("table")) arguments.table = given["table"].as<std::string>();
  arguments.motions = number_of(given, "motions", 50, 100'000);
  arguments.rounds = number_of(given, "rounds", 0, 50);
  const long seed = given["seed"].as<long>();
  if (seed < 0) throw UsageError(fmt::format("--seed: {}, allowed: 0 or more", seed));
  arguments.seed = static_cast<std::uint64_t>(seed);
  arguments.threads = threads_of(given);
  arguments.progress = progress_of(given);
  arguments.shown = shown_lengths_of(given);
  arguments.figure = figure_of(given);
  return arguments;
}

}  // namespace rubsweep::apps
