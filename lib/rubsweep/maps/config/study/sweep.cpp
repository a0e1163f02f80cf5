#include "rubsweep/maps/config/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/model/support_path.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/study/key_axis.hpp"
#include "rubsweep/maps/config/study/place_axes.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::study {
namespace {

/// A refined map looks between neighbours.
void refuse_disorder(const yaml::Section& section, const sweep::Grid& grid) {
  if (const auto axis = sweep::disordered_axis(grid)) {
    section.refuse_together("refine", {"refine"}, fmt::format("beside values of {} in no order", *axis),
                            "values that rise, or fall, all along");
  }
}

/// No table of a support is continued beyond its ends.
void refuse_speeds_beyond_tables(const yaml::Section& section, const sweep::Grid& grid,
                                 const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || grid.speed_hz.empty()) return;
  for (std::size_t i = 0; i < kit->supports.size(); ++i) {
    if (!kit->supports[i].table) continue;
    const double low = kit->supports[i].table->speed_hz.front(),
                 high = kit->supports[i].table->speed_hz.back();
    const auto beyond =
        std::ranges::find_if(grid.speed_hz, [&](double hz) { return !(hz >= low && hz <= high); });
    if (beyond == grid.speed_hz.end()) continue;
    section.refuse_together(
        "speed_hz", {"speed_hz", speed_rpm_key},
        fmt::format("{} is beyond the table of {}", model::speed_text(*beyond), model::support_path(*kit, i)),
        model::speed_range_text(low, high));
    return;
  }
}

}  // namespace

sweep::Grid read_sweep(const yaml::Value& value, const model::Machine& machine) {
  yaml::Section section(value);
  sweep::Grid grid;
  read_speeds(section, grid);
  refuse_speeds_beyond_tables(section, grid, machine);
  read_unbalance(section, machine, grid);
  grid.axes = read_key_axes(section);
  if (const auto refine = section.find("refine")) read_map(*refine, grid.refinement.emplace());
  if (grid.refinement) refuse_disorder(section, grid);
  section.refuse_unknown_keys();
  std::string product = fmt::format("{} x {}", grid.speed_hz.size(), grid.unbalance.size());
  // The product of five long axes is more than an integer holds.
  auto cells = static_cast<double>(grid.speed_hz.size()) * static_cast<double>(grid.unbalance.size());
  for (const sweep::KeyAxis& axis : grid.axes) {
    product += fmt::format(" x {}", axis.values.size());
    cells *= static_cast<double>(axis.values.size());
  }
  if (cells > static_cast<double>(max_cells))
    refuse(value, fmt::format("{} = {} cells", product, cells), fmt::format("at most {}", max_cells));
  return grid;
}

keys::Form sweep_form() {
  using namespace keys;
  const Form speeds = axis_form(model::positive), unbalances = axis_form(model::not_negative),
             over_keys =
                 map_of(joined({key_axis_keys(), spaced_keys(model::any_finite)}), key_axis_choices());
  return map_of(
      joined(
          {{must("speed_hz", speeds, "shaft speeds, in revolutions per second"),
            must("whirl_ratio", unbalances,
                 "unbalance: excursion of the quiet motion / clearance left at the first stop"),
            must("eccentricity_m", unbalances, "unbalance by the eccentricity of the disc")},
           newer({must(std::string(speed_rpm_key), speeds, "shaft speeds, in revolutions per minute"),
                  must(std::string(unbalance_key), unbalances, "unbalance by U: the eccentricity is U / m"),
                  must(std::string(grade_key), unbalances,
                       "unbalance by the balance quality grade G of ISO 21940-11, at the rated speed"),
                  must(std::string(rated_hz_key), number(model::positive), "speed that a grade is taken at"),
                  must(std::string(rated_rpm_key), number(model::positive),
                       "the same, in revolutions per minute"),
                  may("x", over_keys, "axis over other keys of the configuration", "(none)"),
                  may("y", over_keys, "a second axis over other keys", "(none)"),
                  may("z", over_keys, "a third axis over other keys", "(none)"),
                  may("refine", map_of(keys_of<sweep::Refinement>()),
                      "a map without most of its cells, split where neighbours differ", "(none)")})}),
      {either(speed_keys),
       {.ways = {{{"whirl_ratio"}, {}},
                 {{"eccentricity_m"}, {}},
                 {{std::string(unbalance_key)}, {}},
                 {{std::string(grade_key), std::string(rated_hz_key)}, {}},
                 {{std::string(grade_key), std::string(rated_rpm_key)}, {}}}}});
}

void print_sweep(yaml::Printer& printer, const sweep::Grid& grid, AxisPrint how) {
  printer.open("sweep");
  print_place_axis(printer, "speed_hz", grid.written_speed, grid.speed_hz, how);
  print_place_axis(printer, to_string(grid.measure), grid.written_unbalance, grid.unbalance, how);
  print_key_axes(printer, grid.axes, how);
  if (grid.refinement) print_map(printer, "refine", *grid.refinement);
  printer.close();
}

}  // namespace rubsweep::config::study
