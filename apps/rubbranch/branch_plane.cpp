#include "branch_plane.hpp"

#include <fmt/format.h>

#include <memory>

#include "rubsweep/core/error.hpp"
#include "written_cell.hpp"

namespace rubsweep::apps {

BranchPlane branch_plane(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const std::string &along = arguments.along, &key = arguments.curve;
  if (key == along || (is_unbalance(key) && is_unbalance(along))) {
    throw ConfigError(
        fmt::format("--curve {}: is the parameter of --along {}, allowed: another one", key, along));
  }
  require_number("--curve", key, config);
  const auto cell = std::make_shared<const WrittenCell>(arguments, config);
  const double start = cell->value_of(key, {});
  BranchPlane result;
  result.second = range_of(key, {arguments.curve_from, arguments.curve_to}, start, config.study.grid);
  if (!(result.second.low < result.second.high) || !result.second.holds(start)) {
    throw ConfigError(fmt::format(
        "--curve-from and --curve-to: the range of {} from {} to {} must hold that of the cell, {}", key,
        result.second.low, result.second.high, start));
  }
  result.scenes = [cell, along, key](double first, double second) {
    return cell->scene_with({{along, first}, {key, second}});
  };
  result.second_on_branch = [cell, along, key](double first) {
    return cell->value_of(key, {{along, first}});
  };
  return result;
}

}  // namespace rubsweep::apps
