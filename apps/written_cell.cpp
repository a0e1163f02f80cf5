#include "written_cell.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/config/file.hpp"
#include "rubsweep/config/number_at.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::apps {
namespace {

bool is_speed(const std::string& parameter) { return parameter == "speed_hz"; }
bool is_ratio(const std::string& parameter) {
  return parameter == to_string(sweep::UnbalanceMeasure::whirl_ratio);
}

}  // namespace

WrittenCell::WrittenCell(const RubbranchArguments& arguments, const config::RunConfig& config)
    : arguments_(arguments),
      config_(config),
      text_(config::read_config_bytes(arguments.config)),
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
  return scene::build_cell(config.study.machine, speed_hz, unbalance);
}

std::optional<scene::Scene> WrittenCell::scene_with(const std::vector<Written>& all) const {
  try {
    auto cell = with(all);
    if (!cell || !scene::can_run(cell->start)) return std::nullopt;
    return std::move(cell->scene);
  } catch (const ConfigError&) {  // out of what a machine may have
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
  if (!is_key(parameter) || config::number_at(config, parameter)) return;
  throw ConfigError(
      fmt::format("{} {}: the configuration has no such number, allowed: speed_hz, whirl_ratio, "
                  "eccentricity_m, or the key of a number that --set could replace",
                  option, parameter));
}

branch::ParameterRange usual_range(const std::string& parameter, double start, const sweep::Grid& grid) {
  if (is_speed(parameter) || parameter == to_string(grid.measure)) {
    const auto [low, high] = std::ranges::minmax(is_speed(parameter) ? grid.speed_hz : grid.unbalance);
    return {std::min(low, start), std::max(high, start)};
  }
  if (is_unbalance(parameter)) return {0, 2 * start};
  return {std::min(0.5 * start, 2 * start), std::max(0.5 * start, 2 * start)};
}

}  // namespace rubsweep::apps
