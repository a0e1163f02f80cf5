// audit events CELLS SEED [KIND ...]: runs CELLS random machines, of all kinds or of those named, turn by
// turn through the exact solver and through rkf78 at 1e-13. Machines with several dry contacts are compared
// with time stepping instead. Prints how far they agree and writes a configuration for every cell in which
// the exact solver is wrong. Exit code 1 if there is one, or if the friction of a cell could not be decided.

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <string>
#include <vector>

#include "audit/audit_programs.hpp"
#include "audit/dry_audit.hpp"
#include "audit/event_audit.hpp"
#include "audit/written_cell.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::audit {
namespace {

constexpr int turns_of_a_cell = 60, turns_of_dry_cell = 12;

struct Total {
  long stuck = 0, together = 0, unsettled = 0;
  long cells = 0, turns = 0, touched = 0, exact_turns = 0, pieces = 0, grazes = 0, parted = 0,
       exact_failed = 0, other_failed = 0, other_wrong = 0, wrong = 0;

  void add(const EventAudit& cell) {
    ++cells;
    turns += cell.turns;
    touched += cell.touched;
    exact_turns += cell.exact_turns;
    pieces += cell.turns_with_pieces;
    grazes += cell.grazes;
    parted += cell.parted;
    exact_failed += cell.exact_failed;
    other_failed += cell.other_failed;
    other_wrong += cell.other_wrong;
    wrong += cell.difference.has_value();
    stuck += cell.stuck;
    together += cell.stuck_together;
    unsettled += cell.outcome == integrate::run::Outcome::friction_unsettled;
  }
};

EventAudit audited(const CellsAndSeed& asked, std::size_t i) {
  const RandomCell cell = cell_of(asked, i);
  return several_dry(kind_of(asked, i)) ? audit_dry_contacts(cell, turns_of_dry_cell)
                                        : audit_events(cell, turns_of_a_cell);
}

}  // namespace

int events(int argc, char** argv) {
  const auto asked = cells_and_seed(argc, argv);
  if (!asked) {
    fmt::print(stderr, "usage: audit events CELLS SEED [KIND ...]\n");
    return 1;
  }
  const std::size_t count = asked->cells;
  std::vector<EventAudit> results(count);
  const std::atomic<bool> stop = false;
  batch::parallel_run(
      count, 0, [&](std::size_t i) { results[i] = audited(*asked, i); },
      [&](std::size_t i) {
        if (results[i].exact_failed)
          write_cell(cell_of(*asked, i), fmt::format("failed-{}-{}.yaml", asked->seed, i));
        if (!results[i].difference) return;
        const std::string name = fmt::format("missed-event-{}-{}.yaml", asked->seed, i);
        write_cell(cell_of(*asked, i), name);
        const auto& d = *results[i].difference;
        fmt::print("{}: turn {}, exact off by {:.2e}, the other by {:.2e}, {}\n", name, d.turn, d.exact_error,
                   d.other_error, d.first_switch.empty() ? "same changes of mode" : d.first_switch);
        std::fflush(stdout);
      },
      stop);
  fmt::print("{:15} {:>7} {:>9} {:>9} {:>12} {:>7} {:>7} {:>7} {:>12} {:>13} {:>11} {:>6}\n", "stops",
             "cells", "turns", "touching", "closed forms", "pieces", "grazes", "parted", "exact failed",
             "rkf78 failed", "rkf78 wrong", "wrong");
  long wrong = 0, stuck = 0, together = 0;
  for (std::size_t kind = 0; kind < asked->kinds.size(); ++kind) {
    Total total;
    for (std::size_t i = kind; i < count; i += asked->kinds.size()) total.add(results[i]);
    wrong += total.wrong + total.unsettled;
    stuck += total.stuck;
    together += total.together;
    fmt::print("{:15} {:>7} {:>9} {:>9} {:>12} {:>7} {:>7} {:>7} {:>12} {:>13} {:>11} {:>6}\n",
               to_string(asked->kinds[kind]), total.cells, total.turns, total.touched, total.exact_turns,
               total.pieces, total.grazes, total.parted, total.exact_failed, total.other_failed,
               total.other_wrong, total.wrong);
  }
  if (stuck > 0)
    fmt::print(
        "{} turns made again by time stepping have a contact that friction holds, {} two slips at zero\n",
        stuck, together);
  return wrong > 0;
}

}  // namespace rubsweep::audit
