#include "rubdata_arguments.hpp"

#include <fmt/format.h>

#include "shared/command_line.hpp"

namespace rubsweep::apps {
namespace {

po::options_description visible_options() {
  po::options_description options("Options");
  add_output(options, "write there instead of into the study's output directory");
  add_threads(options, "threads; 0: one per processor");
  options.add_options()("check", "read the study, report every problem, make nothing");
  add_progress(options);
  add_last(options);
  return options;
}

}  // namespace

std::string rubdata_help() {
  return fmt::format(
      "rubdata STUDY.yaml [options]\n"
      "Makes labelled recordings of simulated rotors, with and without rub, to develop and to test methods "
      "of diagnosis on.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubdata configs/recordings/rub_recordings.yaml\n"
      "  rubdata configs/recordings/rub_recordings.yaml --threads 2 --output /tmp/recordings\n"
      "  rubdata my_study.yaml --check\n\n"
      "Writes into DIR:\n"
      "  README.md            how the set was made, its files, columns and units\n"
      "  labels.csv           one row for every recording: cause, class, order, proof, all numbers of the "
      "machine\n"
      "  training, validation, test   the recordings, tables or MATLAB files; no machine is in two of them\n"
      "  instrument.yaml      reads each of them with rubscope\n"
      "  recordings.journal   what is finished, to go on from\n\n"
      "The same study and build give the same bytes, whatever the number of threads. Ctrl-C keeps finished "
      "recordings; the same command goes on.\n\n"
      "Exit codes: 0 done; 1 usage; 2 a study that cannot be used, or a directory of another study or build; "
      "3 input/output; 6 another process is at work there; 128+signal when interrupted.\n",
      text_of(visible_options()));
}

RubdataArguments parse_rubdata_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  RubdataArguments arguments{study_arguments(given, "rubdata")};
  if (arguments.action == Action::help || arguments.action == Action::version) return arguments;
  arguments.threads = threads_of(given);
  arguments.progress = progress_of(given);
  return arguments;
}

}  // namespace rubsweep::apps
