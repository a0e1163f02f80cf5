#include "rubbench_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "bench/reference.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "shared/command_line.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::string_view default_tolerances = "1e-4,1e-6,1e-8,1e-10,1e-12";

po::options_description visible_options() {
  po::options_description options("Options");
  options.add_options()(
      "cell", po::value<std::vector<std::string>>()->value_name("SPEED_HZ,UNBALANCE")->composing(),
      "time this cell, the unbalance as the sweep has it (whirl ratio or eccentricity in "
      "metres); may be repeated; default: the rub nearest to the middle of the labelled cells")(
      "steppers", po::value<std::string>()->value_name("NAME,..."), "only these; default: every one")(
      "tolerances", po::value<std::string>()->value_name("R,..."),
      fmt::format("relative tolerances; default: {}", default_tolerances).c_str())(
      "turns", po::value<int>()->value_name("N"), "revolutions of a timed run, from 6 on; default: 30")(
      "repeats", po::value<int>()->value_name("N"),
      "timed runs of each variant; fewer where they take more than 2 s; default: 5")(
      "labels", po::value<std::string>()->value_name("SPEEDSxUNBALANCES"),
      "cells of the sweep to label, spread evenly; 0x0: none; default: 12x6")(
      "label-seconds", po::value<double>()->value_name("S"),
      "time of each variant for its labels; default: 5");
  add_output(options, "write there instead of output.directory + _bench");
  add_set(options);
  add_last(options);
  return options;
}

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<integrate::run::Stepper> read_steppers(const std::string& text) {
  using integrate::adaptive::row_of;
  std::vector<integrate::run::Stepper> steppers;
  const auto all = integrate::adaptive::single_steppers();
  for (const std::string_view name : parts_of(text, ',')) {
    const auto found = std::ranges::find_if(all, [&](auto stepper) { return row_of(stepper).word == name; });
    if (found == all.end()) {
      std::string allowed;
      for (const auto stepper : all) allowed.append(allowed.empty() ? "" : ", ").append(row_of(stepper).word);
      throw UsageError(fmt::format("--steppers: '{}', allowed: {}", name, allowed));
    }
    steppers.push_back(*found);
  }
  return steppers;
}

std::vector<double> read_tolerances(std::string_view text) {
  constexpr auto range = integrate::run::SolverOptions::relative_tolerance_range;
  std::vector<double> tolerances;
  for (const std::string_view part : parts_of(text, ',')) {
    const auto value = number<double>(part);
    if (!value || !(*value >= range.low && *value <= range.high)) {
      throw UsageError(
          fmt::format("--tolerances: '{}', allowed: numbers from {} to {}", part, range.low, range.high));
    }
    tolerances.push_back(*value);
  }
  return tolerances;
}

void read_labels(const std::string& text, RubbenchArguments& arguments) {
  const auto parts = parts_of(text, 'x');
  if (parts.size() == 2) {
    const auto speeds = number<std::size_t>(parts[0]), unbalances = number<std::size_t>(parts[1]);
    if (speeds && unbalances && (*speeds == 0) == (*unbalances == 0)) {
      arguments.label_speeds = *speeds;
      arguments.label_unbalances = *unbalances;
      return;
    }
  }
  throw UsageError("--labels: allowed: SPEEDSxUNBALANCES, two numbers >= 1, or 0x0");
}

int read_count(const po::variables_map& given, const char* name, int low, int otherwise) {
  if (given.count(name) == 0) return otherwise;
  const int value = given[name].as<int>();
  if (value < low) throw UsageError(fmt::format("--{}: allowed: a number >= {}", name, low));
  return value;
}

}  // namespace

RubbenchArguments parse_rubbench_arguments(int argc, const char* const* argv) {
  const po::variables_map given = read_study_command_line(argc, argv, visible_options());
  RubbenchArguments arguments{study_arguments(given, "rubbench")};
  if (arguments.action != Action::run) return arguments;
  if (given.count("cell") != 0) {
    for (const std::string& text : given["cell"].as<std::vector<std::string>>())
      arguments.cells.push_back(read_cell(text));
  }
  const auto every_stepper = integrate::adaptive::single_steppers();
  arguments.steppers = {every_stepper.begin(), every_stepper.end()};
  if (given.count("steppers") != 0) arguments.steppers = read_steppers(given["steppers"].as<std::string>());
  arguments.relative_tolerances = read_tolerances(
      given.count("tolerances") != 0 ? given["tolerances"].as<std::string>() : default_tolerances);
  arguments.work.turns = read_count(given, "turns", arguments.work.error_turns, arguments.work.turns);
  arguments.work.repeats = read_count(given, "repeats", 1, arguments.work.repeats);
  if (given.count("labels") != 0) read_labels(given["labels"].as<std::string>(), arguments);
  if (given.count("label-seconds") != 0) {
    arguments.label_seconds = given["label-seconds"].as<double>();
    if (!(arguments.label_seconds > 0)) throw UsageError("--label-seconds: allowed: a number > 0");
  }
  if (arguments.label_speeds == 0 && arguments.cells.empty())
    throw UsageError("without labels no cell can be chosen: --cell SPEED_HZ,UNBALANCE is needed");
  return arguments;
}

std::string rubbench_help() {
  return fmt::format(
      "rubbench CONFIG.yaml [options]\n"
      "Work against precision: the same cell by every method, stepper, contact handling and tolerance.\n\n"
      "{}\n"
      "Examples:\n"
      "  rubbench configs/benchmark/one_side.yaml --cell 75,0.4\n"
      "  rubbench configs/benchmark/annulus.yaml --steppers dopri5,rkf78 --tolerances 1e-6,1e-9 --labels "
      "6x3\n"
      "  rubbench configs/minimal.yaml --cell 90,0.6 --labels 0x0 --turns 6 --repeats 1 --output /tmp/bench\n"
      "  rubplot work-precision /tmp/bench   (draws it)\n\n"
      "Writes into DIR: work_precision.csv and config.yaml.\n"
      "  microseconds_per_revolution  median of the repeats, variants interleaved; compare within one run "
      "only\n"
      "  state_error                  of the section after 6 revolutions, in (clearance, clearance omega), "
      "from a\n"
      "                               run in long double; with dry friction, torsion, impulse trains or more "
      "than\n"
      "                               {} coordinates from the exact solver, its turns without a closed form "
      "by\n"
      "                               rkf78 at {:g}. How far that reference is known is printed: errors "
      "below "
      "mean\n"
      "                               nothing\n"
      "  label_agreement              share of labelled cells with the reference's class and order; cells "
      "that\n"
      "                               cannot be kicked are left out\n"
      "  steps, switches, rhs_calls   of one timed run\n"
      "A variant is not labelled (labels_too_slow) where one cell may take more than --label-seconds:\n"
      "response.max_revolutions, or 100 revolutions at the stepper's tightest tolerance, which is what "
      "proofs\n"
      "take. One whose time is up has labelled a spread part of the cells (labels_cut).\n"
      "exact without a stepper is the exact solver by itself: closed forms, and Taylor pieces where there "
      "are\n"
      "none. The stepper auto is not listed: at every step it is one of the others.\n\n"
      "Exit codes: 0 done; 1 usage; 2 bad configuration; 3 input/output; 4 done, but a run failed (its "
      "status\n"
      "says why). An interrupted run writes nothing.\n",
      text_of(visible_options()), bench::most_long_double_coordinates, bench::reference_tolerance);
}

}  // namespace rubsweep::apps
