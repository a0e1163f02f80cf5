#include "datasheet.hpp"

#include <fmt/format.h>

#include <iterator>

#include "rubsweep/measurement/dataset/labelled_recording.hpp"
#include "rubsweep/measurement/dataset/labels.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::apps {
namespace {

std::string limits_and_use(const std::string& program) {
  return fmt::format(
      "## What it is not\n\n"
      "No recording is of a real machine: one disc, isotropic supports, a steady speed, contacts that "
      "neither wear nor warm up. A method that is good here has shown that it can tell these simulations "
      "apart. Labels marked `floquet` and `rest` are proven up to rounding for the simulated machine; "
      "`observed` and an empty cell are not.\n\n"
      "## Baseline\n\n"
      "In 500 recordings of the usual ranges with linear contacts, 100 for each of the five kinds, a rule "
      "that knows the spectrum alone named the right kind 212 times, and `rubdiagnose`, which knows the "
      "machine, 323 "
      "times. The rule compares shares of the energy with 0.3 %. More than that between the multiples of "
      "1X: `one_side` where half of it or more lies at multiples of 1/2X, of 1/3X or of 1/4X, else "
      "`annular`. Otherwise, with less at 2X and at 3X: `no_rub`; with more at 2X: `one_side`, with more "
      "at 3X: `two_sides`. All rows are in `results/diagnosis/calibration.csv` of the sources.\n\n"
      "## How to cite\n\n"
      "Cite rubsweep as `CITATION.cff` of its sources says, the version, {}, the study below with its "
      "seed, and the SHA-256 of `labels.csv`, which contains that of every recording.\n\n",
      program);
}

}  // namespace

std::string datasheet(const dataset::DataStudy& study, const std::string& program) {
  const dataset::Measurement& read = study.measurement;
  std::string text = fmt::format(
      "# Simulated recordings of rotors that rub\n\n"
      "{} recordings of {} machines, made by {} and by no machine: every motion is computed.\n\n"
      "## How they were made\n\n"
      "A machine is a Jeffcott rotor (one disc on a massless shaft) with the stops of one candidate, which "
      "take turns. Its numbers are drawn from the ranges below; `recordings_per_machine` recordings share "
      "them, and the direction of the stop, the place of the mark on the shaft and the gains of the probes. "
      "Speed, unbalance, kick and noise are drawn for every recording. The rotor whirls quietly, is kicked "
      "once (from a whirl ratio of 1 on it starts at rest instead), and is followed until its motion is "
      "known, and on until its free vibration has died away to a thousandth ({} turns at most where a stop "
      "is touched). Then the recording begins. Rubs that go deeper in it than {} of the clearance, or strike "
      "harder than {} times the weight of the rotor, are no machine's: speed, unbalance and kick are then "
      "drawn again. So the share of motions in the set is that of starts that lead to them, and many "
      "machines with stops are quiet: `rubs` says which.\n\n"
      "Each probe reads its direction times its gain, with white noise. Lines at -1X, 2X and 3X that no "
      "rub makes (run-out, supports, couplings) are added to every motion; they are smaller than the shares "
      "below of its size, its root mean square about the mean.\n\n"
      "The same study and build of the program give the same bytes, whatever the number of threads.\n\n",
      study.recordings, (study.recordings + study.recordings_per_machine - 1) / study.recordings_per_machine,
      program, diagnose::most_turns_touching, study.rub.penetration_ratio, study.rub.force_ratio);
  fmt::format_to(
      std::back_inserter(text),
      "## Files\n\n"
      "- `labels.csv`: one row for every recording, columns below\n"
      "- `training`, `validation`, `test`: the recordings, {}, about {} turns of the shaft at {} readings a "
      "second\n"
      "- `instrument.yaml`: description for `rubscope RECORDING --instrument instrument.yaml`\n\n"
      "| column of a recording | unit | meaning |\n|---|---|---|\n"
      "| `t_s` | s | time |\n| `x_m` | m | displacement in x, from where the rotor rests |\n{}"
      "| `keyphasor_v` | V | {} while the mark on the shaft passes, for {} of a turn; else {} |\n\n"
      "| column of labels.csv | meaning |\n|---|---|\n",
      study.format == dataset::Format::csv ? "comma-separated tables"
                                           : "MATLAB files of version 5, a vector for each column",
      read.turns, read.sampling_rate_hz, read.probes == 2 ? "| `y_m` | m | displacement in y |\n" : "",
      dataset::mark_v, dataset::mark_share, dataset::no_mark_v);
  for (const dataset::LabelColumn& column : dataset::label_columns())
    fmt::format_to(std::back_inserter(text), "| `{}` | {} |\n", column.name, column.meaning);
  fmt::format_to(std::back_inserter(text),
                 "\nEmpty cells do not apply. Names end with their unit.\n\n"
                 "{}## The study\n\n```\n{}```\n",
                 limits_and_use(program), dataset::study_text(study));
  return text;
}

std::string instrument_yaml(const dataset::DataStudy& study) {
  std::string text =
      "# Probes and mark of every recording of this set, for rubscope.\n"
      "time: t_s\nkeyphasor: {column: keyphasor_v, mark: dark}\nprobes:\n"
      "  - {column: x_m, angle_deg: 0}\n";
  if (study.measurement.probes == 2) text += "  - {column: y_m, angle_deg: 90}\n";
  return text;
}

}  // namespace rubsweep::apps
