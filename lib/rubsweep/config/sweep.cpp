#include "rubsweep/config/sweep.hpp"

#include <fmt/format.h>

#include "rubsweep/config/axis.hpp"
#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
sweep::Grid read_sweep(const Value& value) {
  Section section(value);
  sweep::Grid grid;
  if (const auto speed = section.require("speed_hz", axis_forms)) {
    grid.speed_hz = read_axis(*speed, model::positive);
  }
  section.require_exactly_one({"whirl_ratio", "eccentricity_m"});
  if (const auto ratio = section.find("whirl_ratio")) {
    grid.measure = sweep::UnbalanceMeasure::whirl_ratio;
    grid.unbalance = read_axis(*ratio, model::not_negative);
  }
  if (const auto eccentricity = section.find("eccentricity_m")) {
    grid.measure = sweep::UnbalanceMeasure::eccentricity_m;
    grid.unbalance = read_axis(*eccentricity, model::not_negative);
  }
  section.refuse_unknown_keys();
  const std::size_t cells = grid.speed_hz.size() * grid.unbalance.size();
  if (cells > max_cells) {
    refuse(value, fmt::format("{} x {} = {} cells", grid.speed_hz.size(), grid.unbalance.size(), cells),
           fmt::format("at most {}", max_cells));
  }
  return grid;
}

void print_sweep(Printer& printer, const sweep::Grid& grid) {
  printer.open("sweep");
  printer.open("speed_hz");
  printer.numbers("values", grid.speed_hz);
  printer.close();
  printer.open(to_string(grid.measure));
  printer.numbers("values", grid.unbalance);
  printer.close();
  printer.close();
}

}  // namespace rubsweep::config
