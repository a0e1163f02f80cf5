#include "rubsweep/dataset/recording_text.hpp"

#include <fmt/format.h>
#include <matio.h>

#include <array>
#include <iterator>
#include <memory>
#include <system_error>

#include "rubsweep/error.hpp"

namespace rubsweep::dataset {
namespace {

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};

void add_variable(mat_t* file, const char* name, const std::vector<double>& values,
                  const std::filesystem::path& path) {
  std::array<std::size_t, 2> dimensions{values.size(), 1};
  const std::unique_ptr<matvar_t, FreeVariable> variable(
      Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dimensions.data(),
                    const_cast<double*>(values.data()), MAT_F_DONT_COPY_DATA));
  if (!variable || Mat_VarWrite(file, variable.get(), MAT_COMPRESSION_ZLIB) != 0)
    throw IoError("cannot write " + path.string());
}

}  // namespace

std::string recording_csv(const LabelledRecording& recording) {
  const bool plane = !recording.y_m.empty();
  std::string text = plane ? "t_s,x_m,y_m,keyphasor_v\n" : "t_s,x_m,keyphasor_v\n";
  for (std::size_t k = 0; k < recording.t_s.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{:.7g},{:.7g},", recording.t_s[k], recording.x_m[k]);
    if (plane) fmt::format_to(std::back_inserter(text), "{:.7g},", recording.y_m[k]);
    fmt::format_to(std::back_inserter(text), "{:.7g}\n", recording.keyphasor_v[k]);
  }
  return text;
}

void write_recording_matlab(const LabelledRecording& recording, const std::filesystem::path& file) {
  std::filesystem::path temporary = file;
  temporary += ".part";
  {
    const std::unique_ptr<mat_t, CloseFile> open(
        Mat_CreateVer(temporary.string().c_str(), "MATLAB 5.0 MAT-file, written by rubdata", MAT_FT_MAT5));
    if (!open) throw IoError("cannot write " + temporary.string());
    add_variable(open.get(), "t_s", recording.t_s, temporary);
    add_variable(open.get(), "x_m", recording.x_m, temporary);
    if (!recording.y_m.empty()) add_variable(open.get(), "y_m", recording.y_m, temporary);
    add_variable(open.get(), "keyphasor_v", recording.keyphasor_v, temporary);
  }
  std::error_code failed;
  std::filesystem::rename(temporary, file, failed);
  if (failed) throw IoError("cannot write " + file.string() + ": " + failed.message());
}

}  // namespace rubsweep::dataset
