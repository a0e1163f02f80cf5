#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

}  // namespace rubsweep::dataset
