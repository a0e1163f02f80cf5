#pragma once

#include <string>

#include "rubsweep/measurement/dataset/data_study.hpp"

namespace rubsweep::apps {

/// Description of a set (Gebru et al. 2021, "Datasheets for datasets"): how the set was made, its files,
/// columns and units, and its possible uses and limits. Markdown; `program`: name and version of the writing
/// program.
std::string datasheet(const dataset::DataStudy& study, const std::string& program);

/// Description of the instrument with which rubscope reads every recording of the set.
std::string instrument_yaml(const dataset::DataStudy& study);

}  // namespace rubsweep::apps
