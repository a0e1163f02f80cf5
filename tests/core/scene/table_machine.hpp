#pragma once

#include <vector>

#include "core/scene/kit_machine.hpp"

namespace rubsweep::scene {

/// Speeds of the rows in the table below.
inline const std::vector<double> table_speeds_hz{20, 40, 55, 80, 120};

/// A support given by a table: with the speed its stiffness and the sideways force of its film rise, its
/// damping falls.
inline model::SupportTable film_table() {
  model::SupportTable table;
  table.speed_hz = table_speeds_hz;
  table.columns = {{{2e4, 2.6e4, 3.1e4, 3.3e4, 5e4},
                    {500, 900, 1100, 1300, 2000},
                    {-400, -800, -1000, -1300, -1900},
                    {2.2e4, 2.5e4, 3e4, 3.4e4, 4.6e4},
                    {90, 70, 60, 55, 50},
                    {1, 2, 2, 3, 3},
                    {1, 2, 2, 3, 3},
                    {80, 70, 65, 55, 45},
                    {0, 0, 0, 0, 0},
                    {0, 0, 0, 0, 0}}};
  return table;
}

/// The light shaft with oil films at both ends. `modes` as in model::RotorKit.
inline model::Machine table_machine(std::optional<int> modes = 2) {
  model::Machine machine = light_shaft_machine();
  model::RotorKit& kit = *model::kit_of(machine);
  kit.shaft[0].density_kg_per_m3 = 7800;
  for (model::Support& support : kit.supports) support = model::with_table(support, film_table());
  kit.modes = modes;
  return machine;
}

/// The same machine with constant supports from one row of the table.
inline model::Machine typed_machine(std::size_t row, std::optional<int> modes = 2) {
  model::Machine machine = table_machine(modes);
  const model::SupportTable table = film_table();
  for (model::Support& support : model::kit_of(machine)->supports) {
    support.table.reset();
    support.stiffness_x_n_per_m = table.columns[0][row];
    support.stiffness_xy_n_per_m = table.columns[1][row];
    support.stiffness_yx_n_per_m = table.columns[2][row];
    support.stiffness_y_n_per_m = table.columns[3][row];
    support.damping_x_ns_per_m = table.columns[4][row];
    support.damping_xy_ns_per_m = table.columns[5][row];
    support.damping_yx_ns_per_m = table.columns[6][row];
    support.damping_y_ns_per_m = table.columns[7][row];
  }
  return machine;
}

}  // namespace rubsweep::scene
