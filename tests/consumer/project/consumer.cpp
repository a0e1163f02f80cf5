#include <algorithm>
#include <atomic>
#include <cstdio>
#include <vector>

#include "rubsweep/error.hpp"
#include "rubsweep/machine.hpp"
#include "rubsweep/sweep.hpp"

int main() {
  rubsweep::model::Machine machine{
      .rotor =
          rubsweep::model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02},
      .stops = {{.geometry = rubsweep::model::OneSideGeometry{90},
                 .clearance_m = 1e-3,
                 .stiffness_n_per_m = 2e6,
                 .damping = rubsweep::model::NominalRestitution{0.7},
                 .contact_mass_kg = {},
                 .contact_radius_m = 0.0375,
                 .friction = {},
                 .casing = {}}},
      .kick = {}};
  rubsweep::model::validate(machine);

  rubsweep::sweep::Study study;
  study.machine = machine;
  study.grid.speed_hz = {45, 240};
  study.grid.unbalance = {0.2};
  const std::vector<std::size_t> cells{0, 1};
  const std::atomic<bool> stop = false;
  double fastest_hz = 0;
  const std::size_t finished = rubsweep::sweep::run_cells(
      study, cells, 2,
      [&](std::size_t, const rubsweep::sweep::Row& row) { fastest_hz = std::max(fastest_hz, row.speed_hz); },
      stop);
  std::printf("%zu cells, the last at %g Hz\n", finished, fastest_hz);

  std::get<rubsweep::model::JeffcottRotor>(machine.rotor).mass_kg = -1;
  try {
    rubsweep::model::validate(machine);
  } catch (const rubsweep::ConfigError&) {
    return 0;
  }
  return 1;
}
