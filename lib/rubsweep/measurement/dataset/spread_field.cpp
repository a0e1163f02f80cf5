#include "rubsweep/measurement/dataset/spread_field.hpp"

#include <array>

namespace rubsweep::config::dataset {

void read_spread(yaml::Section& section, std::string_view name, const model::Range& range, bool logarithmic,
                 diagnose::Spread& target) {
  const auto value = section.find(name);
  if (!value) return;
  if (value->node.kind != yaml::Node::Kind::list) {
    if (const auto number = yaml::read_number(*value, range)) target = {*number, *number, false};
    return;
  }
  std::array<double, 2> bounds{};
  if (!yaml::read_numbers(*value, bounds)) return;
  for (const double bound : bounds) {
    if (!model::contains(range, bound)) {
      yaml::refuse(*value, "goes out of range", "a number or [low, high], each " + model::describe(range));
      return;
    }
  }
  if (bounds[0] > bounds[1]) {
    yaml::refuse(*value, "begins above its end", "[low, high]");
    return;
  }
  if (logarithmic && bounds[0] <= 0) {
    yaml::refuse(*value, "begins at 0", "[low, high] above 0, for its logarithm is drawn evenly");
    return;
  }
  target = {bounds[0], bounds[1], logarithmic};
}

}  // namespace rubsweep::config::dataset
