// event_audit CELLS SEED: runs CELLS random machines of every kind turn by turn through the exact solver and
// through rkf78 at 1e-13, prints what they share and writes a configuration for every cell in which the exact
// solver is wrong. Exit code 1 when there is one.

#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <vector>

#include "audit/event_audit.hpp"
#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/config/print_config.hpp"

namespace {

using namespace rubsweep;

constexpr int turns_of_a_cell = 60;

struct Total {
  long cells = 0, turns = 0, touched = 0, exact_turns = 0, grazes = 0, parted = 0, exact_failed = 0, other_failed = 0,
       other_wrong = 0, wrong = 0;

  void add(const audit::EventAudit& cell) {
    ++cells;
    turns += cell.turns;
    touched += cell.touched;
    exact_turns += cell.exact_turns;
    grazes += cell.grazes;
    parted += cell.parted;
    exact_failed += cell.exact_failed;
    other_failed += cell.other_failed;
    other_wrong += cell.other_wrong;
    wrong += cell.difference.has_value();
  }
};

void keep(const audit::RandomCell& cell, const std::string& name) {
  sweep::Study study;
  study.machine = cell.machine;
  study.grid = {{cell.speed_hz}, sweep::UnbalanceMeasure::whirl_ratio, {cell.whirl_ratio}};
  std::ofstream(name) << config::print_study(study) << "output: {directory: " << name << "-map}\n";
}

long number(std::string_view text) {
  long value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: event_audit CELLS SEED\n");
    return 1;
  }
  const auto count = static_cast<std::size_t>(number(argv[1]));
  const auto seed = static_cast<std::uint64_t>(number(argv[2]));
  const auto kind_of = [](std::size_t i) { return audit::stop_kinds[i % audit::stop_kinds.size()]; };
  const auto cell_of = [&](std::size_t i) {
    std::mt19937_64 random(seed * 1'000'003 + i);
    return audit::random_cell(kind_of(i), random);
  };
  std::vector<audit::EventAudit> results(count);
  const std::atomic<bool> stop = false;
  batch::parallel_run(
      count, 0, [&](std::size_t i) { results[i] = audit::audit_events(cell_of(i), turns_of_a_cell); },
      [&](std::size_t i) {
        if (results[i].exact_failed)
          keep(cell_of(i), fmt::format("failed-{}-{}.yaml", seed, i));
        if (!results[i].difference) return;
        const std::string name = fmt::format("missed-event-{}-{}.yaml", seed, i);
        keep(cell_of(i), name);
        const auto& d = *results[i].difference;
        fmt::print("{}: turn {}, exact off by {:.2e}, rkf78 by {:.2e}, {}\n", name, d.turn, d.exact_error,
                   d.other_error, d.first_switch.empty() ? "same changes of mode" : d.first_switch);
        std::fflush(stdout);
      },
      stop);
  fmt::print("{:15} {:>7} {:>9} {:>9} {:>12} {:>7} {:>7} {:>12} {:>13} {:>11} {:>6}\n", "stops", "cells", "turns",
             "touching", "closed forms", "grazes", "parted", "exact failed", "rkf78 failed", "rkf78 wrong", "wrong");
  long wrong = 0;
  for (std::size_t kind = 0; kind < audit::stop_kinds.size(); ++kind) {
    Total total;
    for (std::size_t i = kind; i < count; i += audit::stop_kinds.size()) total.add(results[i]);
    wrong += total.wrong;
    fmt::print("{:15} {:>7} {:>9} {:>9} {:>12} {:>7} {:>7} {:>12} {:>13} {:>11} {:>6}\n",
               audit::to_string(audit::stop_kinds[kind]), total.cells, total.turns, total.touched,
               total.exact_turns, total.grazes, total.parted, total.exact_failed, total.other_failed, total.other_wrong,
               total.wrong);
  }
  return wrong > 0;
}
