#include "branch_family.hpp"

#include <fmt/format.h>

#include <memory>

#include "rubsweep/core/error.hpp"
#include "written_cell.hpp"

namespace rubsweep::apps {

BranchFamily branch_family(const RubbranchArguments& arguments, const config::RunConfig& config) {
  const std::string& along = arguments.along;
  require_number("--along", along, config);
  const auto cell = std::make_shared<const WrittenCell>(arguments, config);
  BranchFamily family;
  family.start = cell->value_of(along, {});
  cell->with({{along, family.start}});  // throws where --set may not change this number
  const branch::orbits::ParameterRange range =
      range_of(along, {arguments.from, arguments.to}, family.start, config.study.grid);
  family.low = range.low;
  family.high = range.high;
  if (!(family.low < family.high) || family.start < family.low || family.start > family.high) {
    throw ConfigError(
        fmt::format("--from and --to: the range of {} from {} to {} must hold that of the cell, {}", along,
                    family.low, family.high, family.start));
  }
  family.scenes = [cell, along](double value) { return cell->scene_with({{along, value}}); };
  return family;
}

}  // namespace rubsweep::apps
