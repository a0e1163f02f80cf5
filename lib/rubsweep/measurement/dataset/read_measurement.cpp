#include "rubsweep/measurement/dataset/read_measurement.hpp"

#include "rubsweep/measurement/dataset/spread_field.hpp"

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
