#include "rubsweep/measurement/diagnosis/diagnosed_machine.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/intervals.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/measurement/diagnose/fitted_parameters.hpp"

namespace rubsweep::diagnosis {
namespace {

namespace fs = std::filesystem;
using Fitted = std::optional<diagnose::FittedParameters>;

/// Relative half widths of the intervals of parameters for which a fit gives none.
constexpr double frequency_share = 0.01, damping_share = 0.2;

constexpr std::size_t likely_kits = 60;  ///< Number of kits that represent all likely ones.

/// Relative margin on both sides of the fitted unbalance, because the unbalance may change from run to run.
constexpr double unbalance_share = 0.25;

/// Interval of the fit if there is one; otherwise the value plus and minus the share `share` of it.
diagnose::Spread interval_of(const Fitted& fitted, const std::string& key, double value, double share,
                             std::vector<std::string>& remarks) {
  const auto interval = fitted ? diagnose::interval_of(*fitted, key) : std::nullopt;
  if (interval && interval->low > 0 && interval->high > interval->low) return *interval;
  remarks.push_back(
      interval ? fmt::format("{}: the interval of the fit reaches 0, {:.0f} % of its value is taken instead",
                             key, 100 * share)
               : fmt::format("{}: no interval is known, {:.0f} % of its value is taken", key, 100 * share));
  return {value / (1 + share), value * (1 + share), false};
}

void set_unbalance(const Fitted& fitted, DiagnosedMachine& diagnosed) {
  const auto interval = fitted ? diagnose::interval_of(*fitted, "eccentricity_m") : std::nullopt;
  if (!interval || !(interval->low > 0)) return;
  diagnosed.eccentricity_m = {interval->low / (1 + unbalance_share), interval->high * (1 + unbalance_share),
                              true};
  diagnosed.remarks.push_back(
      fmt::format("eccentricity_m: {:.3g} to {:.3g}, the interval of the fit and {:.0f} % on either side",
                  diagnosed.eccentricity_m->low, diagnosed.eccentricity_m->high, 100 * unbalance_share));
}

void set_jeffcott(const model::JeffcottRotor& rotor, const Fitted& fitted, const fs::path& file,
                  DiagnosedMachine& diagnosed) {
  if (rotor.damping_ratio == 0)
    throw ConfigError(file.string() +
                      ": rotor.damping_ratio: is 0, allowed: above 0, as no motion would settle");
  diagnosed.fixed.rotor_mass_kg = rotor.mass_kg;
  diagnosed.fixed.rotating_damping_ratio = rotor.rotating_damping_ratio;
  diagnosed.natural_frequency_hz = interval_of(
      fitted, "rotor.natural_frequency_hz", rotor.natural_frequency_hz, frequency_share, diagnosed.remarks);
  diagnosed.damping_ratio =
      interval_of(fitted, "rotor.damping_ratio", rotor.damping_ratio, damping_share, diagnosed.remarks);
  diagnosed.remarks.emplace_back(
      "rotor: has one mode, and so has every candidate: a rub of a rotor with a second bending mode may be "
      "called none of these; a rotor_kit has its modes");
}

/// Fit beside the configuration, or else the intervals in it, which count as those of 95 % of independent
/// errors. Throws ConfigError where there is both.
Fitted known_parameters(const fs::path& file, const std::string& text) {
  Fitted fitted = diagnose::read_fitted_parameters(file.parent_path());
  const std::vector<config::KeyInterval> intervals = config::read_intervals(text, file.string());
  if (intervals.empty()) return fitted;
  if (fitted)
    throw ConfigError(
        fmt::format("{}: {}: has an interval beside parameters.csv of a fit, allowed: one of both",
                    file.string(), intervals.front().key));
  const auto count = static_cast<Eigen::Index>(intervals.size());
  fitted.emplace();
  for (Eigen::VectorXd* column : {&fitted->value, &fitted->low_95, &fitted->high_95}) column->resize(count);
  fitted->error_root = Eigen::MatrixXd::Identity(count, count);
  for (const config::KeyInterval& interval : intervals) {
    const auto i = static_cast<Eigen::Index>(fitted->name.size());
    fitted->name.push_back(interval.key);
    fitted->value(i) = interval.value;
    fitted->low_95(i) = interval.from;
    fitted->high_95(i) = interval.to;
  }
  return fitted;
}

/// Throws ConfigError where the fit belongs to another machine than the configuration beside it.
void require_same_machine(const diagnose::FittedParameters& fitted, const config::RunConfig& config,
                          const fs::path& file) {
  constexpr double rounding = 1e-6;
  for (std::size_t i = 0; i < fitted.name.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const auto here = config::number_at(config, fitted.name[i]);
    const double value = fitted.value(k), away = rounding * std::abs(value);
    if (!here || (*here >= std::fmin(fitted.low_95(k), value - away) &&
                  *here <= std::fmax(fitted.high_95(k), value + away)))
      continue;
    throw ConfigError(
        fmt::format("{}: {}: is {}, but {} in parameters.csv beside it, allowed: the files of one fit",
                    file.string(), fitted.name[i], *here, value));
  }
}

/// Fitted values of the rotor's keys as overrides of a configuration.
std::vector<std::string> overrides_of(const diagnose::FittedParameters& fitted,
                                      const Eigen::VectorXd& values) {
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < fitted.name.size(); ++i)
    if (fitted.name[i].starts_with("rotor."))
      overrides.push_back(fmt::format("{}={}", fitted.name[i], values(static_cast<Eigen::Index>(i))));
  return overrides;
}

/// Kits with parameters drawn from the errors of the fit, the best fit first, without forbidden values.
std::vector<model::RotorKit> fitted_kits(const std::string& text, const fs::path& file,
                                         const diagnose::FittedParameters& fitted, std::uint64_t seed) {
  std::vector<model::RotorKit> kits;
  for (std::size_t k = 0; k < likely_kits; ++k) {
    diagnose::RandomStream random(seed, k, diagnose::DrawPurpose::of_kit);
    const Eigen::VectorXd values = k == 0 ? fitted.value : draw_parameters(fitted, random);
    try {
      const model::Machine machine =
          config::read_machine_text(text, file.string(), overrides_of(fitted, values));
      kits.push_back(*model::kit_of(machine));
    } catch (const ConfigError&) {
      if (k == 0) throw;
    }
  }
  return kits;
}

void draw_kits(const model::RotorKit& kit, const Fitted& fitted, const fs::path& file, std::uint64_t seed,
               DiagnosedMachine& diagnosed) {
  diagnose::refuse_unscalable(kit, file.string());
  if (fitted && !overrides_of(*fitted, fitted->value).empty()) {
    diagnosed.kits = fitted_kits(diagnosed.text, file, *fitted, seed);
    for (std::size_t i = 0; i < fitted->name.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      if (fitted->name[i].starts_with("rotor.") && !std::isfinite(fitted->high_95(k) - fitted->low_95(k)))
        diagnosed.remarks.push_back(fitted->name[i] + ": the fit has no interval, its value is taken");
    }
  } else {
    diagnosed.kits = diagnose::varied_kits(kit, frequency_share, damping_share, likely_kits, seed);
    diagnosed.remarks.push_back(
        fmt::format("rotor: no intervals are known, {:.0f} % of the natural frequencies and {:.0f} % of the "
                    "damping are taken",
                    100 * frequency_share, 100 * damping_share));
  }
}

}  // namespace

void prepare_kits(const fs::path& file, double speed_hz, DiagnosedMachine& diagnosed) {
  if (diagnosed.kits.empty()) return;
  diagnose::KnownKit known = diagnose::known_kit(std::move(diagnosed.kits), speed_hz, file.string());
  diagnosed.fixed.rotor_mass_kg = known.rotor_mass_kg;
  diagnosed.natural_frequency_hz = {known.natural_frequency_hz, known.natural_frequency_hz};
  // A kit contains its own damping, so the damping ratio is not used.
  diagnosed.damping_ratio = {1, 1};
  diagnosed.fixed.kit = std::make_shared<const diagnose::KnownKit>(std::move(known));
}

DiagnosedMachine read_diagnosed_machine(const fs::path& file, std::uint64_t seed) {
  DiagnosedMachine diagnosed;
  diagnosed.text = config::yaml::read_config_bytes(file);
  const config::RunConfig config = config::read_run_config_text(diagnosed.text, file.string(), {});
  const model::Machine& machine = config.study.machine;
  if (machine.gravity_m_per_s2 != 0)
    throw ConfigError(file.string() +
                      ": gravity_m_per_s2: is not 0, allowed: 0, as motions are scaled to the recording");
  const model::Stop& stop = machine.stops.front();
  diagnosed.fixed.contact_radius_m = stop.contact_radius_m;
  if (stop.casing && stop.casing->damping_ratio > 0)
    diagnosed.fixed.casing_damping_ratio = stop.casing->damping_ratio;
  const Fitted fitted = known_parameters(file, diagnosed.text);
  if (fitted) require_same_machine(*fitted, config, file);
  set_unbalance(fitted, diagnosed);
  if (const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor)) {
    set_jeffcott(*rotor, fitted, file, diagnosed);
  } else {
    draw_kits(std::get<model::RotorKit>(machine.rotor), fitted, file, seed, diagnosed);
  }
  if (fitted) diagnosed.text += fitted->text;
  return diagnosed;
}

}  // namespace rubsweep::diagnosis
