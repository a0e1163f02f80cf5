#include "rubsweep/maps/config/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/core/model/element_name.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::study {
namespace {

/// Eccentricity of 1 m in units of the key; 1 after a problem.
double per_metre(const yaml::Value& value, double units) {
  if (std::isnan(units)) return 1;  // the mass is missing, which is reported elsewhere
  if (units > 0 && std::isfinite(units)) return units;
  refuse(value, "has no eccentricity: no disc of the rotor stands off the axis",
         "a disc with a mass and an eccentricity_ratio, or whirl_ratio");
  return 1;
}

/// Rated speed in Hz; 1 after a problem.
double read_rated_speed(yaml::Section& sweep) {
  double rated_hz = 1;
  sweep.require_exactly_one({rated_hz_key, rated_rpm_key});
  if (const auto hz = sweep.find(rated_hz_key)) rated_hz = read_number(*hz, model::positive).value_or(1);
  if (const auto rpm = sweep.find(rated_rpm_key))
    rated_hz = read_number(*rpm, model::positive).value_or(1) / model::rpm_per_hz;
  return rated_hz;
}

void refuse_rated_speed(yaml::Section& sweep) {
  for (const std::string_view key : {rated_hz_key, rated_rpm_key}) {
    if (const auto rated = sweep.find(key))
      refuse(*rated, "no grade is given that it would belong to", "beside " + std::string(grade_key));
  }
}

/// Refuses unsorted values together with `refine`, because a refined map compares neighbours.
void refuse_disorder(const yaml::Section& section, const sweep::Grid& grid) {
  if (const auto axis = sweep::disordered_axis(grid)) {
    section.refuse("refine", fmt::format("beside values of {} in no order", *axis),
                   "values that rise, or fall, all along");
  }
}

/// Refuses speeds outside a table of a support: tables are not extrapolated.
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

/// Prints an axis of speeds or unbalances under the key in which it was written, or under `si_key`. Printed
/// values must read back as the same numbers: SI units are used where decimals in the other unit do not
/// suffice.
void print_place_axis(yaml::Printer& printer, std::string_view si_key, const sweep::WrittenAxis& written,
                      const std::vector<double>& values, AxisPrint how) {
  const bool as_written = how == AxisPrint::as_written;
  const bool spaced =
      as_written && written.spacing && batch::spaced(*written.spacing, written.units_per_si) == values;
  std::vector<double> listed;
  for (const double value : values) {
    if (const auto text = sweep::exactly_in_units(written, value))
      listed.push_back(yaml::parse_number(*text).value);
  }
  const bool by_unit = as_written && !written.is_si() && (spaced || listed.size() == values.size());
  printer.open(by_unit ? std::string_view(written.key) : si_key);
  if (spaced) {
    print_axis_values(printer, values, written.spacing, written.units_per_si);
  } else {
    printer.numbers("values", by_unit ? listed : values);
  }
  printer.close();
  if (by_unit && written.key == grade_key) printer.number(rated_hz_key, written.rated_speed_hz);
}

}  // namespace

void read_speeds(yaml::Section& sweep, sweep::Grid& grid) {
  sweep.require_exactly_one(speed_keys);
  const auto hz = sweep.find("speed_hz"), rpm = sweep.find(speed_rpm_key);
  AxisValues axis;
  if (hz) {
    axis = read_axis(*hz, model::positive);
  } else if (rpm) {
    axis = read_axis(*rpm, model::positive, model::rpm_per_hz);
    grid.written_speed = in_rpm();
  }
  grid.speed_hz = std::move(axis.values);
  grid.written_speed.spacing = axis.spacing;
}

void read_unbalance(yaml::Section& sweep, const model::Machine& machine, sweep::Grid& grid) {
  sweep.require_exactly_one({"whirl_ratio", "eccentricity_m", unbalance_key, grade_key});
  const auto read = [&](const yaml::Value& value, sweep::UnbalanceMeasure measure,
                        sweep::WrittenAxis written) {
    AxisValues axis = read_axis(value, model::not_negative, written.units_per_si);
    grid.measure = measure;
    grid.unbalance = std::move(axis.values);
    grid.written_unbalance = std::move(written);
    grid.written_unbalance.spacing = axis.spacing;
  };
  using enum sweep::UnbalanceMeasure;
  if (const auto ratio = sweep.find("whirl_ratio")) read(*ratio, whirl_ratio, {});
  if (const auto eccentricity = sweep.find("eccentricity_m")) read(*eccentricity, eccentricity_m, {});
  if (const auto unbalance = sweep.find(unbalance_key))
    read(*unbalance, eccentricity_m, in_g_mm(per_metre(*unbalance, model::g_mm_per_metre(machine))));
  if (const auto grade = sweep.find(grade_key)) {
    const double rated_hz = read_rated_speed(sweep),
                 units = per_metre(*grade, model::grade_per_metre(machine, rated_hz));
    read(*grade, eccentricity_m,
         {.key = std::string(grade_key), .unit = "mm/s", .units_per_si = units, .rated_speed_hz = rated_hz});
  } else {
    refuse_rated_speed(sweep);
  }
}

sweep::WrittenAxis in_rpm() {
  return {.key = std::string(speed_rpm_key), .unit = "rpm", .units_per_si = model::rpm_per_hz};
}

sweep::WrittenAxis in_g_mm(double units_per_metre) {
  return {.key = std::string(unbalance_key), .unit = "g mm", .units_per_si = units_per_metre};
}

std::string_view key_by_mass(const yaml::Node& sweep, const model::Machine& machine) {
  if (find_node(sweep, unbalance_key) != nullptr) return unbalance_key;
  if (find_node(sweep, grade_key) != nullptr && model::kit_of(machine) != nullptr) return grade_key;
  return {};
}

sweep::Grid read_sweep(const yaml::Value& value, const model::Machine& machine) {
  yaml::Section section(value);
  sweep::Grid grid;
  read_speeds(section, grid);
  refuse_speeds_beyond_tables(section, grid, machine);
  read_unbalance(section, machine, grid);
  grid.axes = read_key_axes(section);
  if (const auto refine = section.find("refine")) read_map(*refine, grid.refinement.emplace());
  if (grid.refinement) refuse_disorder(section, grid);
  std::string product = fmt::format("{} x {}", grid.speed_hz.size(), grid.unbalance.size());
  // Computed as a double, since the product of five long axes may exceed the range of integers.
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
