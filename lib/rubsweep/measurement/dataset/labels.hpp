#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/dataset/labelled_recording.hpp"

namespace rubsweep::dataset {

struct LabelColumn {
  std::string_view name;     ///< name with its unit
  std::string_view meaning;  ///< a noun, for the datasheet
};

/// Columns of labels.csv.
std::vector<LabelColumn> label_columns();

/// Header line of labels.csv, without its line end.
std::string label_header();

/// Row of labels.csv for one recording; a cell is empty where the machine has no such number.
std::string label_line(const DataStudy& study, const LabelledRecording& recording);

/// Path of a recording below the directory of its set: training/000123.csv.
std::string file_of(const DataStudy& study, const LabelledRecording& recording);

/// Everything that decides the bytes of a set, one item per line: the text whose digest identifies the study.
std::string study_text(const DataStudy& study);

/// Description of a set (Gebru et al. 2021, "Datasheets for datasets"): how the set was made, its files,
/// columns and units, and its possible uses and limits. Markdown; `program`: name and version of the writing
/// program.
std::string datasheet(const DataStudy& study, const std::string& program);

/// Description of the instrument with which rubscope reads every recording of the set.
std::string instrument_yaml(const DataStudy& study);

}  // namespace rubsweep::dataset
