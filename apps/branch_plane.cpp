#include "branch_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/config/file.hpp"
#include "rubsweep/config/number_at.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/scene/build_scene.hpp"

namespace rubsweep::apps {
namespace {

bool is_speed(const std::string& key) { return key == "speed_hz"; }
bool is_ratio(const std::string& key) { return key == to_string(sweep::UnbalanceMeasure::whirl_ratio); }
bool is_unbalance(const std::string& key) {
  return is_ratio(key) || key == to_string(sweep::UnbalanceMeasure::eccentricity_m);
}
bool is_key(const std::string& key) { return !is_speed(key) && !is_unbalance(key); }

/// The cell with both parameters written over it.
class Plane {
 public:
  Plane(const RubbranchArguments& arguments, const config::RunConfig& config)
      : arguments_(arguments),
        grid_(config.study.grid),
        text_(config::read_config_bytes(arguments.config)),
        prepared_(
            std::make_shared<const scene::PreparedMachine>(scene::prepare_machine(config.study.machine))) {}

  std::optional<scene::Scene> scene_at(double first, double second) const {
    try {
      auto cell = cell_at({{arguments_.along, first}, {arguments_.curve, second}});
      if (!cell || !scene::can_run(cell->start)) return std::nullopt;
      return std::move(cell->scene);
    } catch (const ConfigError&) {  // out of what a machine may have
      return std::nullopt;
    }
  }

  double second_at_cell(double number_of_key) const { return second_in(cell_at({}), number_of_key); }

  double second_on_branch(double first, double number_of_key) const {
    const auto cell = cell_at({{arguments_.along, first}});
    if (!cell)
      throw ConfigError(fmt::format("--along {}: there is no machine at {}", arguments_.along, first));
    return second_in(cell, number_of_key);
  }

 private:
  struct Written {
    const std::string& key;
    double value;
  };

  double second_in(const std::optional<scene::Cell>& cell, double number_of_key) const {
    if (is_speed(arguments_.curve)) return arguments_.cell.speed_hz;
    if (is_key(arguments_.curve)) return number_of_key;
    return is_ratio(arguments_.curve) ? cell->whirl_ratio : cell->eccentricity_m;
  }

  /// Empty where a parameter is out of what it may be.
  std::optional<scene::Cell> cell_at(const std::vector<Written>& all) const {
    double speed_hz = arguments_.cell.speed_hz;
    scene::Unbalance unbalance = sweep::unbalance_of(grid_, arguments_.cell.unbalance);
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

  RubbranchArguments arguments_;
  sweep::Grid grid_;
  std::string text_;
  std::shared_ptr<const scene::PreparedMachine> prepared_;
};

/// As that of --along: what the sweep covers, of a key from half of what it is to twice that.
branch::ParameterRange usual_range(const std::string& key, double start, const sweep::Grid& grid) {
  if (is_speed(key) || key == to_string(grid.measure)) {
    const auto [low, high] = std::ranges::minmax(is_speed(key) ? grid.speed_hz : grid.unbalance);
    return {std::min(low, start), std::max(high, start)};
  }
  if (is_unbalance(key)) return {0, 2 * start};
  return {std::min(0.5 * start, 2 * start), std::max(0.5 * start, 2 * start)};
}

}  // namespace

BranchPlane branch_plane(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const std::string& key = arguments.curve;
  if (key == arguments.along || (is_unbalance(key) && is_unbalance(arguments.along))) {
    throw ConfigError(fmt::format("--curve {}: is the parameter of --along {}, allowed: another one", key,
                                  arguments.along));
  }
  const auto number = is_key(key) ? config::number_at(config, key) : 0;
  if (!number) {
    throw ConfigError(
        fmt::format("--curve {}: the configuration has no such number, allowed: speed_hz, whirl_ratio, "
                    "eccentricity_m, or "
                    "the key of a number that --set could replace",
                    key));
  }
  const auto plane = std::make_shared<const Plane>(arguments, config);
  const double start = plane->second_at_cell(*number);
  const branch::ParameterRange usual = usual_range(key, start, config.study.grid);
  BranchPlane result;
  result.second = {arguments.curve_from.value_or(usual.low), arguments.curve_to.value_or(usual.high)};
  if (!(result.second.low < result.second.high) || !result.second.holds(start)) {
    throw ConfigError(fmt::format(
        "--curve-from and --curve-to: the range of {} from {} to {} must hold that of the cell, {}", key,
        result.second.low, result.second.high, start));
  }
  result.scenes = [plane](double first, double second) { return plane->scene_at(first, second); };
  result.second_on_branch = [plane, number = *number](double first) {
    return plane->second_on_branch(first, number);
  };
  return result;
}

}  // namespace rubsweep::apps
