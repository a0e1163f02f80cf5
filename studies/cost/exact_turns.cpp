// exact_turns N: runs only N turns of the exact solver in the cell of parameter set A (75 Hz, whirl ratio
// 0.4), for scripts/count_operations.sh.
#include <cstdio>
#include <cstdlib>

#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"

int main(int argc, char** argv) {
  using namespace rubsweep;
  if (argc != 2) {
    std::printf("usage: exact_turns N\n");
    return 1;
  }
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(test::cell_of({}).scene, {}, modes);
  integrate::run::TurnReport turn;
  for (long k = std::atol(argv[1]); k > 0; --k) {
    if (run.advance({}, turn) != integrate::run::Outcome::ok) return 1;
  }
  return 0;
}
