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

std::vector<LabelColumn> label_columns();  ///< Columns of labels.csv.

std::string label_header();  ///< Header line of labels.csv, without its line end.

/// Row of labels.csv for one recording; a cell is empty where the machine has no such number.
std::string label_line(const DataStudy& study, const LabelledRecording& recording);

/// Path of a recording below the directory of its set: training/000123.csv.
std::string file_of(const DataStudy& study, const LabelledRecording& recording);

/// Everything that decides the bytes of a set, one item per line: the text whose digest identifies the study.
std::string study_text(const DataStudy& study);

}  // namespace rubsweep::dataset
