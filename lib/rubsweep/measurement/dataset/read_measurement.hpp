#pragma once

#include <string_view>

#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/prior_spread.hpp"

namespace rubsweep::config::dataset {

/// Reads a number, which is then known, or a list of two, the bounds of an interval; `logarithmic` is how
/// every part of an interval is equally likely. Leaves `target` as it is where the key is missing.
void read_spread(yaml::Section& section, std::string_view name, const model::Range& range, bool logarithmic,
                 diagnose::Spread& target);

/// Reads how the motions of a data set are measured: turns, sampling_rate_hz, probes, and what read_measuring
/// reads.
rubsweep::dataset::Measurement read_measurement(const yaml::Value& value);

/// Reads what is known of noise, of lines of other origin, and of gains: noise_share, backward_1x_share,
/// order_2_share, order_3_share, gain_error.
void read_measuring(const yaml::Value& value, diagnose::Measuring& measuring);

}  // namespace rubsweep::config::dataset
