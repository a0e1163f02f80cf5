#include "written_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/config/line_keys.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

bool is_speed(const std::string& parameter) { return parameter == "speed_hz"; }
bool is_ratio(const std::string& parameter) {
  return parameter == to_string(sweep::UnbalanceMeasure::whirl_ratio);
}

/// Whether a key belongs to the machine; other keys only control how motions are computed and evaluated.
bool is_of_the_machine(const std::string& key) {
  const std::string first = key.substr(0, key.find('.'));
  constexpr std::array<std::string_view, 5> others{"sweep", "study", "solver", "response", "output"};
  return std::ranges::find(others, first) == others.end();
}

branch::orbits::ParameterRange usual_range(const std::string& parameter, double start,
                                           const sweep::Grid& grid) {
  if (is_speed(parameter) || parameter == to_string(grid.measure)) {
    const auto [low, high] = std::ranges::minmax(is_speed(parameter) ? grid.speed_hz : grid.unbalance);
    return {std::min(low, start), std::max(high, start)};
  }
  if (start == 0)
    throw UsageError(fmt::format("{} is 0 here, which says no range: both ends of it are needed", parameter));
  if (is_unbalance(parameter)) return {0, 2 * start};
  return {std::min(0.5 * start, 2 * start), std::max(0.5 * start, 2 * start)};
}

}  // namespace

WrittenCell::WrittenCell(const RubbranchArguments& arguments, const config::RunConfig& config)
    : arguments_(arguments),
      config_(config),
      text_(config::yaml::read_config_bytes(arguments.config)),
      prepared_(
          std::make_shared<const scene::PreparedMachine>(scene::prepare_machine(config.study.machine))) {}

std::optional<scene::Cell> WrittenCell::with(const std::vector<Written>& all) const {
  double speed_hz = arguments_.cell.speed_hz;
  scene::Unbalance unbalance = sweep::unbalance_of(config_.study.grid, arguments_.cell.unbalance);
  std::vector<std::string> overrides = arguments_.overrides;
  for (const auto& [key, value] : all) {
    if (is_key(key)) {
      overrides.push_back(key + "=" + batch::csv_number(value));
    } else if (is_speed(key)) {
      speed_hz = value;
    } else if (!(value >= 0)) {
      return std::nullopt;
    } else {
      unbalance = is_ratio(key) ? scene::Unbalance(scene::WhirlRatio{value})
                                : scene::Unbalance(scene::Eccentricity{value});
    }
  }
  if (!(speed_hz > 0)) return std::nullopt;
  if (overrides.size() == arguments_.overrides.size())
    return scene::build_cell(*prepared_, speed_hz, unbalance);
  const auto config = config::read_run_config_text(text_, arguments_.config.string(), overrides);
  // The machine is reduced for all speeds, as for cells without an override, because a branch needs the same
  // coordinates everywhere.
  return scene::build_cell(scene::prepare_machine(config.study.machine), speed_hz, unbalance);
}

std::optional<scene::Scene> WrittenCell::scene_with(const std::vector<Written>& all) const {
  try {
    auto cell = with(all);
    if (!cell || !scene::can_run(cell->start)) return std::nullopt;
    return std::move(cell->scene);
  } catch (const ConfigError&) {  // the machine may not have these values
    return std::nullopt;
  }
}

double WrittenCell::value_of(const std::string& key, const std::vector<Written>& all) const {
  const auto cell = with(all);
  if (!cell) {
    throw ConfigError(all.empty() ? "--cell: there is no machine at it"
                                  : fmt::format("--along {}: there is no machine at {}", all.front().key,
                                                all.front().value));
  }
  if (is_speed(key)) return arguments_.cell.speed_hz;
  if (is_key(key)) return config::number_at(config_, key).value();
  return is_ratio(key) ? cell->whirl_ratio : cell->eccentricity_m;
}

bool is_key(const std::string& parameter) { return !is_speed(parameter) && !is_unbalance(parameter); }

bool is_unbalance(const std::string& parameter) {
  return is_ratio(parameter) || parameter == to_string(sweep::UnbalanceMeasure::eccentricity_m);
}

void require_number(std::string_view option, const std::string& parameter, const config::RunConfig& config) {
  if (!is_key(parameter)) return;
  const bool known = config::number_at(config, parameter).has_value();
  if (known && is_of_the_machine(parameter)) return;
  throw ConfigError(fmt::format(
      "{} {}: {}, allowed: speed_hz, whirl_ratio, eccentricity_m, or the key of a number "
      "of rotor, stops, kick, start or gravity_m_per_s2 that --set could replace",
      option, parameter, known ? "is no part of the machine" : "the configuration has no such number"));
}

branch::orbits::ParameterRange range_of(const std::string& parameter, const AskedRange& asked, double start,
                                        const sweep::Grid& grid) {
  if (asked.low && asked.high) return {*asked.low, *asked.high};
  const branch::orbits::ParameterRange usual = usual_range(parameter, start, grid);
  return {asked.low.value_or(usual.low), asked.high.value_or(usual.high)};
}

}  // namespace rubsweep::apps
