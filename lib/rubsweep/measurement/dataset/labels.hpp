#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/dataset/labelled_recording.hpp"

namespace rubsweep::dataset {

struct LabelColumn {
  std::string_view name;     ///< with its unit
  std::string_view meaning;  ///< a noun, for the datasheet
};

/// Columns of labels.csv.
std::vector<LabelColumn> label_columns();

/// Header of labels.csv, without its end.
std::string label_header();

/// One row of it; what a machine does not have is empty.
std::string label_line(const DataStudy& study, const LabelledRecording& recording);

/// Path of a recording below the directory of its set: training/000123.csv.
std::string file_of(const DataStudy& study, const LabelledRecording& recording);

/// Everything that decides the bytes of a set, a line each: what its digest is made of.
std::string study_text(const DataStudy& study);

/// Description of a set (Gebru et al. 2021, "Datasheets for datasets"): how it was made, files, columns and
/// units, what it is fit for and what not. Markdown; `program`: name and version of what wrote it.
std::string datasheet(const DataStudy& study, const std::string& program);

/// Description of the instrument for rubscope, which reads every recording of the set with it.
std::string instrument_yaml(const DataStudy& study);

}  // namespace rubsweep::dataset
