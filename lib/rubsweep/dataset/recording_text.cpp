#include "rubsweep/dataset/recording_text.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <system_error>
#include <vector>

#include "rubsweep/batch/input_file.hpp"
#include "rubsweep/batch/leftovers.hpp"
#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/error.hpp"
#include "rubsweep/recording/matlab_file.hpp"

namespace rubsweep::dataset {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

/// File under a name that no recording has, which the next process removes where this one is killed.
struct Scratch {
  fs::path path;
  explicit Scratch(fs::path file) : path(batch::temporary_beside(file += scratch_ending)) {}
  ~Scratch() {
    std::error_code none;
    fs::remove(path, none);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

struct RecordingColumn {
  const char* name;
  const std::vector<double>& values;
};

std::vector<RecordingColumn> columns_of(const LabelledRecording& recording) {
  std::vector<RecordingColumn> columns{{"t_s", recording.t_s}, {"x_m", recording.x_m}};
  if (!recording.y_m.empty()) columns.push_back({"y_m", recording.y_m});
  columns.push_back({"keyphasor_v", recording.keyphasor_v});
  return columns;
}

/// Writes a MATLAB file; false where the library says that it could not.
bool write_columns(const std::vector<RecordingColumn>& columns, const fs::path& path) {
  std::unique_ptr<mat_t, CloseFile> open(
      Mat_CreateVer(path.string().c_str(), "MATLAB 5.0 MAT-file, written by rubdata", MAT_FT_MAT5));
  if (!open) return false;
  for (const RecordingColumn& column : columns) {
    std::array<std::size_t, 2> dimensions{column.values.size(), 1};
    const std::unique_ptr<matvar_t, FreeVariable> variable(
        Mat_VarCreate(column.name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dimensions.data(),
                      const_cast<double*>(column.values.data()), MAT_F_DONT_COPY_DATA));
    if (!variable || Mat_VarWrite(open.get(), variable.get(), MAT_COMPRESSION_ZLIB) != 0) return false;
  }
  return Mat_Close(open.release()) == 0;
}

/// Whether a MATLAB file has these columns: the library buffers, and does not report every write that fails.
bool holds(const fs::path& path, const std::vector<RecordingColumn>& columns) {
  try {
    const recording::Channels read = recording::read_matlab_file(path);
    bool same = read.channels.size() == columns.size();
    for (std::size_t i = 0; same && i < columns.size(); ++i)
      same = read.channels[i].name == columns[i].name && read.channels[i].values == columns[i].values;
    return same;
  } catch (const ConfigError&) {
    return false;
  }
}

}  // namespace

std::string recording_csv(const LabelledRecording& recording) {
  const bool plane = !recording.y_m.empty();
  std::string text = plane ? "t_s,x_m,y_m,keyphasor_v\n" : "t_s,x_m,keyphasor_v\n";
  for (std::size_t k = 0; k < recording.t_s.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{:.12g},{:.7g},", recording.t_s[k], recording.x_m[k]);
    if (plane) fmt::format_to(std::back_inserter(text), "{:.7g},", recording.y_m[k]);
    fmt::format_to(std::back_inserter(text), "{:.7g}\n", recording.keyphasor_v[k]);
  }
  return text;
}

std::string write_recording_matlab(const LabelledRecording& recording, const fs::path& file) {
  const Scratch scratch(file);
  const std::vector<RecordingColumn> columns = columns_of(recording);
  if (!write_columns(columns, scratch.path))
    throw IoError("cannot write " + scratch.path.string() + ": the MATLAB file could not be made there");
  if (!holds(scratch.path, columns))
    throw IoError("cannot write " + scratch.path.string() +
                  ": what was written cannot be read back, as on a full disk");
  std::string bytes = batch::read_input(scratch.path);
  batch::write_whole_file(file, bytes);
  return bytes;
}

}  // namespace rubsweep::dataset
