#pragma once

#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::config::dataset {

/// Reads how the motions of a data set are measured: turns, sampling_rate_hz, probes, and what read_measuring
/// reads.
rubsweep::dataset::Measurement read_measurement(const yaml::Value& value);

/// Reads what is known of noise, of lines of other origin, and of gains: noise_share, backward_1x_share,
/// order_2_share, order_3_share, gain_error.
void read_measuring(const yaml::Value& value, diagnose::Measuring& measuring);

}  // namespace rubsweep::config::dataset
