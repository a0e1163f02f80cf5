// audit proofs CELLS SEED [KIND ...]: settles CELLS random machines, of all kinds or of those named,
// continues every proven orbit without proofs, and prints the results. Writes a minimised configuration for
// every proof that the run contradicts. Exit code 1 if there is one.

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <vector>

#include "audit/audit_programs.hpp"
#include "audit/proof_audit.hpp"
#include "audit/written_cell.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::audit {
namespace {
using response::motion::Proof;

struct Total {
  long cells = 0, rest = 0, floquet = 0, floquet_observed = 0, observed = 0, followed_turns = 0,
       undecided = 0, wrong_floquet = 0, wrong_observed = 0;

  void add(const ProofAudit& cell) {
    cells += cell.simulated;
    rest += cell.proof == Proof::rest;
    floquet += cell.proof == Proof::floquet;
    floquet_observed += cell.proof == Proof::floquet_observed;
    observed += cell.proof == Proof::observed;
    followed_turns += cell.turns;
    undecided += cell.undecided;
    const bool wrong = cell.followed && !cell.confirmed && !cell.undecided;
    wrong_floquet += wrong && cell.proof == Proof::floquet;
    wrong_observed += wrong && cell.proof == Proof::floquet_observed;
  }
};

}  // namespace

int proofs(int argc, char** argv) {
  const auto asked = cells_and_seed(argc, argv);
  if (!asked) {
    fmt::print(stderr, "usage: audit proofs CELLS SEED [KIND ...]\n");
    return 1;
  }
  const std::size_t count = asked->cells;
  std::vector<ProofAudit> results(count);
  const std::atomic<bool> stop = false;
  batch::parallel_run(
      count, 0, [&](std::size_t i) { results[i] = audit_proof(cell_of(*asked, i)); },
      [&](std::size_t i) {
        const ProofAudit& cell = results[i];
        if (!cell.followed || cell.confirmed || cell.undecided) return;
        const std::string name = fmt::format("false-proof-{}-{}.yaml", asked->seed, i);
        fmt::print("{}: {} {} after {} turns\n", name, to_string(*cell.proof), cell.finding, cell.turns);
        std::fflush(stdout);
        write_cell(minimised(cell_of(*asked, i)), name);
      },
      stop);
  constexpr auto form = "{:15} {:>7} {:>7} {:>9} {:>17} {:>9} {:>15} {:>10} {:>14} {:>15}\n";
  fmt::print(form, "stops", "cells", "rest", "floquet", "floquet_observed", "observed", "followed turns",
             "undecided", "false floquet", "false observed");
  long wrong = 0;
  for (std::size_t kind = 0; kind < asked->kinds.size(); ++kind) {
    Total total;
    for (std::size_t i = kind; i < count; i += asked->kinds.size()) total.add(results[i]);
    wrong += total.wrong_floquet + total.wrong_observed;
    fmt::print(form, to_string(asked->kinds[kind]), total.cells, total.rest, total.floquet,
               total.floquet_observed, total.observed, total.followed_turns, total.undecided,
               total.wrong_floquet, total.wrong_observed);
  }
  return wrong > 0;
}

}  // namespace rubsweep::audit
