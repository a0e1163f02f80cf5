// diagnosis_calibration FIRST COUNT SEED CASES: diagnoses recordings of machines drawn from the priors of
// rubdata, with the candidates in turn. It works like rubdiagnose, with CASES motions per candidate. Prints
// one CSV line per recording: the truth, the probabilities, and the ranks of the true numbers in their
// posterior distributions. Machines, motions and readings come from rubdata, whose code the diagnosis does
// not use.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foreign_motion.hpp"
#include "nearest_candidate.hpp"
#include "rubsweep/measurement/dataset/labelled_recording.hpp"
#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"
#include "rubsweep/measurement/diagnose/inference/quantity.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "studied_machine.hpp"

namespace {

using namespace rubsweep;
using diagnose::Unknown;
using diagnose::inference::Quantity;

/// Draws until the motion agrees with its candidate; empty where that happens too rarely.
std::optional<dataset::LabelledRecording> draw_recording(const dataset::DataStudy& study) {
  constexpr std::size_t most_draws = 60;
  const bool rubs = study.candidates[0].cause != diagnose::Cause::no_rub;
  for (std::size_t index = 0; index < most_draws; ++index) {
    response::motion::Workspace workspace;
    dataset::LabelledRecording recording = dataset::make_recording(study, index, workspace);
    if (recording.motion.rubs == rubs) return recording;
  }
  return std::nullopt;
}

recording::Recording measured(const dataset::LabelledRecording& labelled) {
  recording::Channels channels;
  channels.channels.push_back({"t", "s", labelled.t_s});
  channels.channels.push_back({"x", "m", labelled.x_m});
  if (!labelled.y_m.empty()) channels.channels.push_back({"y", "m", labelled.y_m});
  channels.channels.push_back({"key", "V", labelled.keyphasor_v});
  recording::Instrument instrument;
  instrument.time = "t";
  instrument.probes.push_back({.column = "x"});
  if (!labelled.y_m.empty()) instrument.probes.push_back({.column = "y", .angle_deg = 90});
  instrument.keyphasor = recording::Keyphasor{.column = "key"};
  return recording::make_recording(channels, instrument, "simulated");
}

double truth_of(const dataset::LabelledRecording& labelled, Quantity quantity) {
  switch (quantity) {
    case Quantity::clearance: return labelled.clearance_m;
    case Quantity::stop_angle: return labelled.stop_angle_deg;
    case Quantity::position: return 0;  // a Jeffcott rotor has no positions along the shaft
    case Quantity::contact_fraction: return labelled.motion.contact.contact_fraction;
    case Quantity::peak_force: return labelled.motion.contact.peak_contact_force_n;
    case Quantity::eccentricity: return labelled.motion.eccentricity_m;
    case Quantity::whirl_ratio: return value_of(labelled.values, Unknown::whirl_ratio);
    case Quantity::stiffness: return value_of(labelled.values, Unknown::stiffness);
    case Quantity::restitution: return value_of(labelled.values, Unknown::restitution);
    case Quantity::friction: return value_of(labelled.values, Unknown::friction);
    case Quantity::exponent: return value_of(labelled.values, Unknown::exponent);
  }
  return 0;
}

diagnose::features::DescribedMotion seen_in(const recording::Recording& recording,
                                            const diagnose::inference::DiagnosisProblem& problem) {
  response::spectrum::SpectrumWorkspace workspace;
  const auto count = static_cast<std::size_t>(problem.turns) * recording::samples_per_revolution;
  const std::span all(recording.displacement_m);
  const auto lines = diagnose::lines_of(all.last(count), problem.turns,
                                        diagnose::inference::seen_order(problem.measuring), workspace);
  return diagnose::features::describe(lines, diagnose::inference::view_of(problem.measuring), workspace);
}

/// Verdict of a simple rule based on the spectrum alone ("look for 1/2, 1/3 ..."; Muszynska 1989, Goldman and
/// Muszynska 1999).
diagnose::Cause by_rule(const diagnose::features::DescribedMotion& seen) {
  const auto share = [&](std::string_view name) {
    for (const diagnose::features::Feature& feature : seen.features)
      if (feature.name == name) return std::pow(10, feature.value);
    return 0.0;
  };
  double fractions = 0;
  for (const char* name :
       {"energy at multiples of 1/2X", "energy at multiples of 1/3X", "energy at multiples of 1/4X"})
    fractions = std::max(fractions, share(name));
  constexpr double seen_at_all = 3e-3;
  const double between = share("energy between multiples");
  if (between > seen_at_all && fractions > between / 2) return diagnose::Cause::one_side;
  if (between > seen_at_all) return diagnose::Cause::annular;
  const double second = share("energy at 2X") + share("energy at -2X"),
               third = share("energy at 3X") + share("energy at -3X");
  if (std::max(second, third) < seen_at_all) return diagnose::Cause::no_rub;
  return second > third ? diagnose::Cause::one_side : diagnose::Cause::two_sides;
}

/// Quantities that a Jeffcott rotor has.
std::vector<Quantity> asked_quantities() {
  std::vector<Quantity> asked;
  std::ranges::copy_if(diagnose::inference::all_quantities, std::back_inserter(asked),
                       [](Quantity quantity) { return quantity != Quantity::position; });
  return asked;
}

void print_header() {
  std::string line = "machine,truth,motion_class,order,sampling_rate_hz,probes,speed_ratio";
  for (const diagnose::Cause cause : diagnose::all_causes) line += fmt::format(",{}", to_string(cause));
  line += ",none,p_value,sharpness,motions,rule,nearest,share_of_nearest";
  line += ",effective_cases";
  for (const Quantity quantity : asked_quantities())
    line += fmt::format(",rank_of_{}", diagnose::inference::to_string(quantity));
  fmt::print("{}\n", line);
}

struct Truth {
  std::string cause, motion_class;
  int order = 0;
  std::optional<std::size_t> candidate{};
  const dataset::LabelledRecording* labelled = nullptr;
};

/// Posterior probability, given the true candidate, of a value below the true one. Equal values, as for a
/// contact that never ends, get a random rank among each other.
double rank_of(const diagnose::inference::Marginal& marginal, double value, std::mt19937_64& random) {
  constexpr double equal = 1e-6;
  const double from = marginal.probability_below(value - equal * std::abs(value)),
               to = marginal.probability_up_to(value + equal * std::abs(value));
  return std::uniform_real_distribution<double>(from, std::max(from, to) + 1e-12)(random);
}

/// CSV columns of effective cases and ranks. Empty where there is no candidate; ranks are also empty where no
/// case resembles the recording or the quantity does not exist.
std::string columns_of_numbers(const diagnose::inference::Diagnosis& diagnosis, const Truth& truth,
                               std::mt19937_64& random) {
  if (!truth.candidate) return std::string(asked_quantities().size() + 1, ',');
  const double count = diagnose::inference::effective_cases(weights_of(diagnosis, *truth.candidate));
  std::string columns = fmt::format(",{:.1f}", count);
  for (const Quantity quantity : asked_quantities()) {
    columns += ',';
    for (const auto& [known, marginal] : diagnosis.marginals[*truth.candidate])
      if (known == quantity)
        columns += fmt::format("{:.4f}", rank_of(marginal, truth_of(*truth.labelled, quantity), random));
  }
  return columns;
}

void print_row(std::size_t machine, const Truth& truth, const StudiedMachine& studied,
               const recording::Recording& recording, const diagnose::inference::DiagnosisProblem& problem,
               const diagnose::features::DescribedMotion& seen,
               const diagnose::inference::Diagnosis& diagnosis, std::mt19937_64& random_ranks) {
  const bool clipped = std::ranges::any_of(recording.findings, [](const std::string& finding) {
    return finding.find("clipped") != std::string::npos;
  });
  const auto [nearest, share] = diagnose::nearest_candidate(seen, problem, diagnosis);
  std::string line = fmt::format("{},{},{},{},{},{},{:.3f}", machine, truth.cause, truth.motion_class,
                                 truth.order, studied.sampling_rate_hz, studied.probes, studied.speed_ratio);
  for (const double p : diagnosis.posterior.probability) line += fmt::format(",{:.4f}", p);
  line += fmt::format(",{:.4f},{:.4f},{:.3f},{},{},{},{:.3f}", clipped ? 1 : diagnosis.posterior.none,
                      diagnosis.p_value, diagnosis.posterior.sharpness, diagnosis.set.cases.size(),
                      to_string(by_rule(seen)), problem.candidates[nearest].name, share);
  line += columns_of_numbers(diagnosis, truth, random_ranks);
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// A recording of a machine whose vibration has a cause outside the candidates.
dataset::LabelledRecording draw_foreign(Foreign cause, const StudiedMachine& studied,
                                        std::mt19937_64& random) {
  dataset::LabelledRecording labelled;
  labelled.speed_hz = studied.speed_ratio * studied.frequency_hz;
  labelled.mark_turns = std::uniform_real_distribution<double>(0, 1)(random);
  for (int probe = 0; probe < studied.probes; ++probe)
    labelled.gain.push_back(1 + 0.02 * std::normal_distribution<double>()(random));
  const dataset::Measurement measurement{.sampling_rate_hz = studied.sampling_rate_hz,
                                         .probes = studied.probes};
  labelled.motion.displacement_m =
      foreign_motion(cause, studied.speed_ratio, studied.damping_ratio, measurement.turns,
                     diagnose::samples_per_revolution, random);
  diagnose::RandomStream readings(random(), 0, 0);
  read_motion(measurement, readings, labelled);
  if (cause == Foreign::clipped_sensor) {
    const double largest = *std::ranges::max_element(labelled.x_m);
    const double limit = largest * std::uniform_real_distribution<double>(0.5, 0.9)(random);
    for (double& x : labelled.x_m) x = std::min(x, limit);
  }
  return labelled;
}

void run(std::size_t machine, std::uint64_t seed, int cases) {
  std::mt19937_64 random(seed * 1'000'003 + machine);
  const StudiedMachine studied = draw_studied(machine, random);
  const diagnose::inference::DiagnosisProblem problem = problem_of(studied, random(), random);
  diagnose::inference::DiagnosisOptions options;
  options.cases.cases_per_candidate = cases;
  options.cases.threads = 1;
  options.with_standard_error = false;
  const diagnose::inference::CaseSet set = prior_cases(problem, options.cases);
  std::mt19937_64 random_ranks(~(seed * 1'000'003 + machine));
  const auto answer = [&](const dataset::LabelledRecording& labelled, const Truth& truth) {
    const recording::Recording recording = measured(labelled);
    const diagnose::features::DescribedMotion seen = seen_in(recording, problem);
    print_row(machine, truth, studied, recording, problem, seen,
              diagnose::inference::diagnose(problem, seen, options, set), random_ranks);
  };
  constexpr std::size_t recordings_per_candidate = 2, foreign_recordings = 2;
  for (std::size_t k = 0; k < recordings_per_candidate * problem.candidates.size(); ++k) {
    const std::size_t truth = k % problem.candidates.size();
    const auto labelled = draw_recording(study_of(studied, problem.candidates[truth].cause, random()));
    if (!labelled) continue;
    answer(*labelled, {problem.candidates[truth].name, std::string(to_string(labelled->motion.motion_class)),
                       labelled->motion.order.value_or(0), truth, &*labelled});
  }
  for (std::size_t k = 0; k < foreign_recordings; ++k) {
    const Foreign cause = all_foreign[(foreign_recordings * machine + k) % all_foreign.size()];
    answer(draw_foreign(cause, studied, random),
           {std::string(to_string(cause)), "", 0, std::nullopt, nullptr});
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) return 1;
  const auto number = [&](int k) { return static_cast<std::size_t>(std::strtoul(argv[k], nullptr, 10)); };
  print_header();
  for (std::size_t machine = number(1); machine < number(1) + number(2); ++machine)
    run(machine, number(3), static_cast<int>(number(4)));
}
