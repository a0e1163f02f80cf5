#include "branch_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/config/file.hpp"
#include "rubsweep/config/number_at.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::apps {
namespace {

std::optional<scene::Scene> scene_of(scene::Cell cell) {
  if (!scene::can_run(cell.start)) return std::nullopt;
  return std::move(cell.scene);
}

/// The range given, else that of the axis; the value itself where an axis has one value.
void set_range(const RubbranchArguments& arguments, double low, double high, BranchFamily& family) {
  family.low = arguments.from.value_or(std::min(low, family.start));
  family.high = arguments.to.value_or(std::max(high, family.start));
  if (!(family.low < family.high) || family.start < family.low || family.start > family.high) {
    throw ConfigError(
        fmt::format("--from and --to: the range of {} from {} to {} must hold that of the cell, {}",
                    arguments.along, family.low, family.high, family.start));
  }
}

BranchFamily along_speed(const RubbranchArguments& arguments, const sweep::Grid& grid,
                         std::shared_ptr<const scene::PreparedMachine> prepared) {
  BranchFamily family;
  family.start = arguments.cell.speed_hz;
  const scene::Unbalance unbalance = sweep::unbalance_of(grid, arguments.cell.unbalance);
  family.scenes = [prepared = std::move(prepared),
                   unbalance](double speed_hz) -> std::optional<scene::Scene> {
    if (!(speed_hz > 0)) return std::nullopt;
    return scene_of(scene::build_cell(*prepared, speed_hz, unbalance));
  };
  const auto [low, high] = std::ranges::minmax(grid.speed_hz);
  set_range(arguments, low, high, family);
  return family;
}

BranchFamily along_unbalance(const RubbranchArguments& arguments, const sweep::Grid& grid,
                             std::shared_ptr<const scene::PreparedMachine> prepared) {
  const bool ratio = arguments.along == to_string(sweep::UnbalanceMeasure::whirl_ratio);
  const double speed_hz = arguments.cell.speed_hz;
  const scene::Cell cell =
      scene::build_cell(*prepared, speed_hz, sweep::unbalance_of(grid, arguments.cell.unbalance));
  BranchFamily family;
  family.start = ratio ? cell.whirl_ratio : cell.eccentricity_m;
  family.scenes = [prepared = std::move(prepared), speed_hz,
                   ratio](double value) -> std::optional<scene::Scene> {
    if (!(value >= 0)) return std::nullopt;
    const scene::Unbalance unbalance =
        ratio ? scene::Unbalance(scene::WhirlRatio{value}) : scene::Unbalance(scene::Eccentricity{value});
    return scene_of(scene::build_cell(*prepared, speed_hz, unbalance));
  };
  if (arguments.along == to_string(grid.measure)) {
    const auto [low, high] = std::ranges::minmax(grid.unbalance);
    set_range(arguments, low, high, family);
  } else {
    set_range(arguments, 0, 2 * family.start, family);
  }
  return family;
}

BranchFamily along_key(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const auto value = config::number_at(config, arguments.along);
  if (!value) {
    throw ConfigError(
        fmt::format("--along {}: the configuration has no such number, allowed: speed_hz, "
                    "whirl_ratio, eccentricity_m, or the key of a number that --set could replace",
                    arguments.along));
  }
  BranchFamily family;
  family.start = *value;
  const std::string text = config::read_config_bytes(arguments.config);
  const auto machine_at = [text, arguments](double at) {
    std::vector<std::string> overrides = arguments.overrides;
    overrides.push_back(arguments.along + "=" + batch::csv_number(at));
    return config::read_run_config_text(text, arguments.config.string(), overrides).study.machine;
  };
  machine_at(family.start);
  const scene::Unbalance unbalance = sweep::unbalance_of(config.study.grid, arguments.cell.unbalance);
  const double speed_hz = arguments.cell.speed_hz;
  family.scenes = [machine_at, unbalance, speed_hz](double at) -> std::optional<scene::Scene> {
    try {
      return scene_of(scene::build_cell(machine_at(at), speed_hz, unbalance));
    } catch (const ConfigError&) {  // out of what a machine may have
      return std::nullopt;
    }
  };
  set_range(arguments, std::min(0.5 * *value, 2 * *value), std::max(0.5 * *value, 2 * *value), family);
  return family;
}

}  // namespace

BranchFamily branch_family(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const auto prepared =
      std::make_shared<const scene::PreparedMachine>(scene::prepare_machine(config.study.machine));
  if (arguments.along == "speed_hz") return along_speed(arguments, config.study.grid, prepared);
  if (arguments.along == to_string(sweep::UnbalanceMeasure::whirl_ratio) ||
      arguments.along == to_string(sweep::UnbalanceMeasure::eccentricity_m))
    return along_unbalance(arguments, config.study.grid, prepared);
  return along_key(arguments, config);
}

}  // namespace rubsweep::apps
