#include <atomic>
#include <cstdio>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

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

  const std::vector<double> speed_hz = rubsweep::batch::evenly_spaced(45, 240, 5);
  std::vector<double> ratio(speed_hz.size());
  const std::atomic<bool> stop = false;
  rubsweep::batch::parallel_run(
      speed_hz.size(), 2,
      [&](std::size_t cell) {
        ratio[cell] =
            speed_hz[cell] / std::get<rubsweep::model::JeffcottRotor>(machine.rotor).natural_frequency_hz;
      },
      [](std::size_t) {}, stop);
  std::printf("%zu speeds, the last %g Hz, %g natural frequencies\n", speed_hz.size(), speed_hz.back(),
              ratio.back());

  std::get<rubsweep::model::JeffcottRotor>(machine.rotor).mass_kg = -1;
  try {
    rubsweep::model::validate(machine);
  } catch (const rubsweep::ConfigError&) {
    return 0;
  }
  return 1;
}
