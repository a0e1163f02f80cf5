#pragma once

#include <string>

#include "rubsweep/measurement/dataset/data_study.hpp"

namespace rubsweep::dataset {

/// Everything that decides the bytes of a set, a line each: what its digest is made of.
std::string study_text(const DataStudy& study);

/// Description of a set (Gebru et al. 2021, "Datasheets for datasets"): how it was made, files, columns and
/// units, what it is fit for and what not. Markdown; `program`: name and version of what wrote it.
std::string datasheet(const DataStudy& study, const std::string& program);

/// Description of the instrument for rubscope, which reads every recording of the set with it.
std::string instrument_yaml(const DataStudy& study);

}  // namespace rubsweep::dataset
