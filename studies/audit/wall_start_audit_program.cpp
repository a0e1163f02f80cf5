// audit wall_starts STARTS SEED: compares the first turn of STARTS random machines whose rotor begins at a
// wall, by all solvers, with fixed steps that locate no events. Prints every start with a wrong result; exit
// code 1 if there is one.

#include <fmt/format.h>

#include <atomic>
#include <cstdlib>
#include <vector>

#include "audit/audit_programs.hpp"
#include "audit/wall_start.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::audit {

int wall_starts(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: audit wall_starts STARTS SEED\n");
    return 1;
  }
  const auto count = static_cast<std::size_t>(std::atol(argv[1]));
  const auto seed = static_cast<std::uint64_t>(std::atol(argv[2]));
  std::vector<WallStartAudit> found(count);
  const std::atomic<bool> stop = false;
  batch::parallel_run(
      count, 0, [&](std::size_t i) { found[i] = audit_wall_start(random_wall_start(seed, i)); },
      [](std::size_t) {}, stop);
  int wrong = 0, decided = 0;
  for (std::size_t i = 0; i < count; ++i) {
    decided += found[i].decides;
    if (!found[i].wrong || !found[i].decides) continue;
    ++wrong;
    fmt::print("{}: {}; fixed steps to {:.1e}", i, random_wall_start(seed, i).description, found[i].spread);
    for (std::size_t k = 0; k < wall_start_solvers.size(); ++k)
      fmt::print(", {} {:.1e}", wall_start_solvers[k], found[i].errors[k]);
    fmt::print("\n");
  }
  fmt::print("{} starts, {} decided by fixed steps, {} wrong\n", count, decided, wrong);
  return wrong > 0;
}

}  // namespace rubsweep::audit
