#include "rubsweep/maps/config/study/place_axes.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "rubsweep/core/model/balance.hpp"
#include "rubsweep/maps/config/yaml/number.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"

namespace rubsweep::config::study {
namespace {

/// How many of the key's units one metre of eccentricity is; 1 after a problem.
double per_metre(const yaml::Value& value, double units) {
  if (std::isnan(units)) return 1;  // the mass is missing, which is said where it belongs
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

std::string_view key_by_mass(const yaml::Node& sweep, const model::Machine& machine) {
  if (find_node(sweep, unbalance_key) != nullptr) return unbalance_key;
  if (find_node(sweep, grade_key) != nullptr && model::kit_of(machine) != nullptr) return grade_key;
  return {};
}

}  // namespace rubsweep::config::study
