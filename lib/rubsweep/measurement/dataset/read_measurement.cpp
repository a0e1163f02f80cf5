#include "rubsweep/measurement/dataset/read_measurement.hpp"

#include <array>

namespace rubsweep::config::dataset {
namespace {

constexpr model::Range any_share{.low = 0, .high = 1}, noise{.low = 0, .high = 1, .low_open = true};
/// The time of each reading is written with twelve digits.
constexpr model::Range rate_hz{.low = 0, .high = 1e6, .low_open = true};

void read_disturbances(yaml::Section& section, diagnose::Spread& noise_share, diagnose::OtherLines& lines,
                       double& gain_error) {
  read_spread(section, "noise_share", noise, true, noise_share);
  section.field("backward_1x_share", lines.backward_1x, any_share);
  section.field("order_2_share", lines.order_2, any_share);
  section.field("order_3_share", lines.order_3, any_share);
  section.field("gain_error", gain_error, any_share);
}

}  // namespace

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

rubsweep::dataset::Measurement read_measurement(const yaml::Value& value) {
  yaml::Section section(value);
  rubsweep::dataset::Measurement measurement;
  section.field("turns", measurement.turns, yaml::IntegerRange{8, 1024});
  section.field("sampling_rate_hz", measurement.sampling_rate_hz, rate_hz);
  section.field("probes", measurement.probes, yaml::IntegerRange{1, 2});
  read_disturbances(section, measurement.noise_share, measurement.other_lines, measurement.gain_error);
  section.refuse_unknown_keys();
  return measurement;
}

void read_measuring(const yaml::Value& value, diagnose::Measuring& measuring) {
  yaml::Section section(value);
  read_disturbances(section, measuring.noise_share, measuring.other_lines, measuring.gain_error);
  section.refuse_unknown_keys();
}

}  // namespace rubsweep::config::dataset
