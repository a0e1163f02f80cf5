#pragma once

#include <string>
#include <string_view>

#include "rubsweep/measurement/dataset/data_study.hpp"

namespace rubsweep::config::dataset {

/// Reads the study of a data set: recordings, recordings_per_machine, seed, machine, speed_ratio, candidates,
/// measurement, split, format, output. `name` stands for the file in messages. Throws ConfigError with every
/// problem.
rubsweep::dataset::DataStudy read_data_study_text(std::string_view text, const std::string& name);

}  // namespace rubsweep::config::dataset
