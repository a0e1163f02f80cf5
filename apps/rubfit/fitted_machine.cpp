#include "fitted_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/recently_used.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"
#include "rubsweep/measurement/fit/rub/rub_orbits.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

/// Names of parameters that are not configuration keys. If such a parameter is not fitted, an option gives
/// its value.
constexpr std::array<std::string_view, 4> own_names{fit::eccentricity_name, fit::mark_name, fit::hit_name,
                                                    fit::rate_name};

bool is_key(const std::string& name) { return std::ranges::find(own_names, name) == own_names.end(); }

/// Values of the parameters that are configuration keys, in the form of --set.
std::vector<std::string> overrides_of(const std::vector<fit::Parameter>& parameters,
                                      const Eigen::VectorXd& values) {
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (is_key(parameters[i].name))
      overrides.push_back(
          fmt::format("{}={:.17g}", parameters[i].name, values(static_cast<Eigen::Index>(i))));
  }
  return overrides;
}

bool allowed(const std::string& text, const std::string& key, double value) {
  try {
    config::read_run_config_text(text, "the fitted configuration", {fmt::format("{}={:.17g}", key, value)});
    return true;
  } catch (const ConfigError&) {
    return false;
  }
}

/// The bound, moved towards the start until the configuration accepts it.
double drawn_in(const std::string& text, const std::string& key, double start, double bound) {
  if (allowed(text, key, bound)) return bound;
  double good = 0, bad = 1;
  constexpr int halvings = 20;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (good + bad) / 2;
    (allowed(text, key, start + middle * (bound - start)) ? good : bad) = middle;
  }
  return start + good * (bound - start);
}

/// Number under a key. For a list of equal numbers, such as the damping ratios of all modes, it is this
/// number.
std::optional<double> start_of(const config::RunConfig& config, const std::string& key) {
  if (const auto number = config::number_at(config, key)) return number;
  const auto first = config::number_at(config, key + ".0");
  for (int i = 1; first; ++i) {
    const auto next = config::number_at(config, fmt::format("{}.{}", key, i));
    if (!next) break;
    if (*next != *first) return std::nullopt;
  }
  return first;
}

double own_start(const RubfitArguments& arguments, const std::string& name) {
  if (name == fit::eccentricity_name) return arguments.eccentricity_m;
  if (name == fit::mark_name) return arguments.mark_deg;
  if (name == fit::hit_name) return arguments.hit_s;
  return arguments.rate_hz_per_s.value_or(0);
}

/// Middle of two bounds; geometric where both are positive and more than a decade apart.
double middle(double low, double high) {
  return low > 0 && high > 10 * low ? std::sqrt(low * high) : (low + high) / 2;
}

fit::Parameter parameter_of(const RubfitArguments& arguments, const FittedKey& key,
                            const config::RunConfig& config, const std::string& text) {
  constexpr double factor = 20, half_turn_deg = 180;
  const bool own = !is_key(key.name), angle = key.name.ends_with("_deg");
  const std::optional<double> there = own ? own_start(arguments, key.name) : start_of(config, key.name);
  if (!there)
    throw UsageError(fmt::format(
        "--fit {}: is no number of the configuration, allowed: a key that --print-config shows, {}", key.name,
        fmt::join(own_names, ", ")));
  fit::Parameter parameter{.name = key.name, .start = key.start.value_or(*there)};
  if (key.low && !key.start && (parameter.start <= *key.low || parameter.start >= *key.high))
    parameter.start = middle(*key.low, *key.high);
  if (!key.low && !angle && parameter.start == 0)
    throw UsageError(
        fmt::format("--fit {}: begins at 0, allowed: with bounds, {}=LOW:HIGH", key.name, key.name));
  const double start = parameter.start;
  parameter.low = key.low.value_or(angle ? start - half_turn_deg : std::min(start / factor, start * factor));
  parameter.high =
      key.high.value_or(angle ? start + half_turn_deg : std::max(start / factor, start * factor));
  if (!own) {
    parameter.low = drawn_in(text, key.name, start, parameter.low);
    parameter.high = drawn_in(text, key.name, start, parameter.high);
  }
  if (!(parameter.low < parameter.high))
    throw UsageError(fmt::format("--fit {}: nothing else than {} is allowed there", key.name, start));
  constexpr double angle_scale_deg = 30;
  parameter.scale = angle        ? angle_scale_deg
                    : start != 0 ? std::abs(start)
                                 : (parameter.high - parameter.low) / 10;
  return parameter;
}

std::vector<fit::MeasuredData> data_of(const RubfitArguments& arguments,
                                       const std::vector<double>& angle_deg) {
  const auto phases = arguments.phases.value_or(fit::PhaseConvention::sensor);
  std::vector<fit::MeasuredData> data;
  for (const auto& file : arguments.ring_downs)
    data.push_back({file.string(), fit::read_ring_down(file, arguments.from_s), false});
  for (const auto& file : arguments.run_ups)
    data.push_back({file.string(), fit::read_run_up(file), arguments.run_out});
  for (const auto& file : arguments.steady)
    data.push_back({file.string(), fit::read_steady(file, angle_deg, phases), arguments.run_out});
  for (const auto& file : arguments.ramped_speeds)
    data.push_back({file.string(),
                    fit::as_run_up(fit::read_steady(file, angle_deg, phases), *arguments.rate_hz_per_s,
                                   arguments.window_turns),
                    arguments.run_out});
  for (const auto& directory : arguments.rubs)
    data.push_back({directory.string(), fit::read_rub(directory), false});
  return data;
}

/// Recently prepared machines of a fit. Steps along parameters that are not keys, and difference steps of
/// derivatives, need the same machine again. Several threads may use it.
class LastMachines {
 public:
  std::optional<scene::PreparedMachine> find(const std::vector<std::string>& overrides) {
    const std::lock_guard lock(mutex_);
    const Kept* found = machines_.find([&](const Kept& kept) { return kept.first == overrides; });
    return found == nullptr ? std::nullopt : std::optional(found->second);
  }
  void keep(std::vector<std::string> overrides, const scene::PreparedMachine& machine) {
    const std::lock_guard lock(mutex_);
    machines_.emplace(std::move(overrides), machine);
    machines_.trim();
  }

 private:
  using Kept = std::pair<std::vector<std::string>, scene::PreparedMachine>;
  std::mutex mutex_;
  numerics::RecentlyUsed<Kept> machines_{4};
};

/// Function that prepares the machine of a printed configuration for values of these parameters.
auto machine_of(std::string text, std::vector<fit::Parameter> parameters,
                std::shared_ptr<const scene::PreparedMachine> first) {
  return [text = std::move(text), parameters = std::move(parameters), first = std::move(first),
          last = std::make_shared<LastMachines>()](const Eigen::VectorXd& values) {
    std::vector<std::string> overrides = overrides_of(parameters, values);
    if (auto known = last->find(overrides)) return *known;
    scene::PreparedMachine machine =
        fit::prepare_again(config::read_machine_text(text, "the fitted configuration", overrides), *first);
    last->keep(std::move(overrides), machine);
    return machine;
  };
}

fit::rub::AskedLines asked_of(const fit::RubLines& rub, double eccentricity_m) {
  return {rub.speed_hz, eccentricity_m, rub.turns, rub.order};
}

}  // namespace

FittedMachine fitted_machine_of(const RubfitArguments& arguments, const config::RunConfig& config) {
  FittedMachine fitted{
      .problem = {},
      .text = config::print_config(config),
      .first = std::make_shared<const scene::PreparedMachine>(scene::prepare_machine(config.study.machine))};
  fit::MachineFit& problem = fitted.problem;
  problem = {.parameters = {},
             .data = data_of(arguments, linear::sensor_rows(*fitted.first).angle_deg),
             .eccentricity_m = arguments.eccentricity_m,
             .mark_deg = arguments.mark_deg,
             .hit_s = arguments.hit_s,
             .machine = {}};
  for (const FittedKey& key : arguments.keys)
    problem.parameters.push_back(parameter_of(arguments, key, config, fitted.text));
  const bool rotating = arguments.run_ups.size() + arguments.steady.size() + arguments.ramped_speeds.size() +
                            arguments.rubs.size() >
                        0;
  if (rotating && arguments.eccentricity_m == 0 &&
      std::ranges::find(arguments.keys, fit::eccentricity_name, &FittedKey::name) == arguments.keys.end())
    throw UsageError("--eccentricity-m: is needed with 1X, or --fit eccentricity_m=LOW:HIGH");
  if (rotating && arguments.eccentricity_m == 0 &&
      std::ranges::find(arguments.without, fit::eccentricity_name) != arguments.without.end())
    throw UsageError("--compare-without eccentricity_m: needs --eccentricity-m, what it is without a fit");
  problem.machine = machine_of(fitted.text, problem.parameters, fitted.first);
  const auto orbits = std::make_shared<fit::rub::RubOrbits>(config.study.solver, config.study.response);
  problem.rub_lines = [orbits](const scene::PreparedMachine& machine, const fit::RubLines& rub,
                               double eccentricity_m) {
    return orbits->lines_m(machine, asked_of(rub, eccentricity_m));
  };
  problem.follow_rub = [orbits](const scene::PreparedMachine& machine, const fit::RubLines& rub,
                                double eccentricity_m) {
    orbits->follow(machine, asked_of(rub, eccentricity_m));
  };
  return fitted;
}

void take_phases_as(fit::PhaseConvention other, fit::PhaseConvention read_as, FittedMachine& fitted) {
  const std::vector<double> angle_deg = linear::sensor_rows(*fitted.first).angle_deg;
  for (fit::MeasuredData& data : fitted.problem.data) fit::take_phases_as(other, read_as, angle_deg, data);
}

fit::MachineFit without(const FittedMachine& fitted, const std::vector<std::string>& names) {
  fit::MachineFit less = fitted.problem;
  std::erase_if(less.parameters, [&](const fit::Parameter& parameter) {
    return std::ranges::find(names, parameter.name) != names.end();
  });
  less.machine = machine_of(fitted.text, less.parameters, fitted.first);
  return less;
}

std::string fitted_config(const FittedMachine& fitted, const Eigen::VectorXd& values) {
  return config::print_config(config::read_run_config_text(fitted.text, "the fitted configuration",
                                                           overrides_of(fitted.problem.parameters, values)));
}

}  // namespace rubsweep::apps
