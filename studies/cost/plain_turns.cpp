// plain_turns N: runs N turns of the cell of parameter set A (75 Hz, whirl ratio 0.4) by the plain dopri5
// that is the unit of speed ratios, for scripts/check_baseline.sh. Prints the processor time per turn in
// microseconds.
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "support/plain_dopri5.hpp"

int main(int argc, char** argv) {
  const int turns = argc == 2 ? std::atoi(argv[1]) : 0;
  if (turns < 1) {
    std::printf("usage: plain_turns N\n");
    return 1;
  }
  const std::clock_t start = std::clock();
  const rubsweep::test::PlainRun run = rubsweep::test::run_plain_dopri5({}, turns, 1e-6);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("%.3f us per turn, %ld calls, x %.17g m\n", 1e6 * seconds / turns, run.rhs_calls, run.state[0]);
  return 0;
}
