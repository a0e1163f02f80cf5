#include "diagnosed_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <variant>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::apps {
namespace {

namespace fs = std::filesystem;

/// 95 % interval of a parameter that was fitted.
std::optional<diagnose::Spread> fitted_interval(const fs::path& table, const std::string& parameter) {
  if (!fs::exists(table)) return std::nullopt;
  batch::CsvReader rows(table);
  const std::size_t name = rows.column("parameter"), low = rows.column("low_95"),
                    high = rows.column("high_95");
  while (rows.next())
    if (rows.cells()[name] == parameter) return diagnose::Spread{rows.number(low), rows.number(high), false};
  return std::nullopt;
}

/// The interval of the fit, else a share about the value.
diagnose::Spread interval_of(const fs::path& table, const std::string& key, double value, double share,
                             std::vector<std::string>& remarks) {
  if (const auto fitted = fitted_interval(table, key)) {
    if (fitted->low > 0 && fitted->high > fitted->low) return *fitted;
    remarks.push_back(fmt::format("{}: the interval of {} reaches 0, {:.0f} % of its value is taken instead",
                                  table.string(), key, 100 * share));
  } else {
    remarks.push_back(
        fmt::format("{}: no interval is known, {:.0f} % of its value is taken", key, 100 * share));
  }
  return {value / (1 + share), value * (1 + share), false};
}

}  // namespace

DiagnosedMachine read_diagnosed_machine(const fs::path& file) {
  const config::RunConfig config = config::read_run_config(file, {});
  const model::Machine& machine = config.study.machine;
  const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor);
  if (!rotor) throw ConfigError(file.string() + ": rotor: is a rotor kit, allowed: a Jeffcott rotor");
  if (rotor->damping_ratio == 0)
    throw ConfigError(file.string() +
                      ": rotor.damping_ratio: is 0, allowed: above 0, as no motion would settle");
  if (machine.gravity_m_per_s2 != 0)
    throw ConfigError(file.string() +
                      ": gravity_m_per_s2: is not 0, allowed: 0, as motions are scaled to the recording");
  DiagnosedMachine diagnosed;
  const model::Stop& stop = machine.stops.front();
  diagnosed.fixed.rotor_mass_kg = rotor->mass_kg;
  diagnosed.fixed.contact_radius_m = stop.contact_radius_m;
  if (stop.casing && stop.casing->damping_ratio > 0)
    diagnosed.fixed.casing_damping_ratio = stop.casing->damping_ratio;
  const fs::path table = file.parent_path() / "parameters.csv";
  diagnosed.natural_frequency_hz =
      interval_of(table, "rotor.natural_frequency_hz", rotor->natural_frequency_hz, 0.01, diagnosed.remarks);
  diagnosed.damping_ratio =
      interval_of(table, "rotor.damping_ratio", rotor->damping_ratio, 0.2, diagnosed.remarks);
  return diagnosed;
}

}  // namespace rubsweep::apps
