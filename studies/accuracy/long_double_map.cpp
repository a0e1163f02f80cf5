// long_double_map CONFIG [STRIDE]: compares the exact solver on a whole one-side map (every STRIDE-th cell in
// both directions) with a hand-written Runge-Kutta-Fehlberg 7(8) in long double. Prints the error of the
// section after the kick and 20 turns, its quantiles over the cells, and every cell with an error above
// 1e-10.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "support/long_double_reference.hpp"
#include "support/set_a_cell.hpp"

int main(int argc, char** argv) {
  using namespace rubsweep;
  if (argc < 2) {
    std::printf("usage: long_double_map CONFIG [STRIDE]\n");
    return 1;
  }
  constexpr int turns = 20, steps_per_turn = 1000;
  constexpr double notable = 1e-10;
  const auto stride = static_cast<std::size_t>(argc > 2 ? std::atoi(argv[2]) : 1);
  const sweep::Grid grid = config::read_run_config(argv[1], {}).study.grid;
  integrate::exact::modes::ModeCache modes;
  std::vector<double> errors;
  for (std::size_t u = 0; u < grid.unbalance.size(); u += stride) {
    for (std::size_t s = 0; s < grid.speed_hz.size(); s += stride) {
      test::OneSideRotor rotor;  // parameter set A, like the configuration
      rotor.speed_hz = grid.speed_hz[s];
      rotor.whirl_ratio = grid.unbalance[u];
      const auto reference = test::long_double_sections(rotor, turns, steps_per_turn);
      const integrate::run::Run run = integrate::start(test::cell_of(rotor).scene, {}, modes);
      integrate::run::TurnReport turn;
      for (int k = 0; k < turns; ++k) {
        if (run.advance({}, turn) != integrate::run::Outcome::ok) std::printf("failed in turn %d\n", k);
      }
      errors.push_back(test::section_error(turn.section, reference[turns], rotor));
      if (errors.back() > notable) {
        std::printf("%.6g Hz, whirl ratio %.4f: %.1e after %d turns, %ld switches\n", rotor.speed_hz,
                    rotor.whirl_ratio, errors.back(), turns, turn.effort.switches);
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  std::printf("%zu cells, %d turns: median %.1e, 90 %% below %.1e, 99 %% below %.1e, largest %.1e\n",
              errors.size(), turns, errors[errors.size() / 2], errors[errors.size() * 9 / 10],
              errors[errors.size() * 99 / 100], errors.back());
  return 0;
}
