#include "rubsweep/dataset/recording_text.hpp"

#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "rubsweep/batch/whole_file.hpp"
#include "rubsweep/matlab/version_5.hpp"

namespace rubsweep::dataset {

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

std::string write_recording_matlab(const LabelledRecording& recording, const std::filesystem::path& file) {
  std::vector<matlab::NamedVector> columns{{"t_s", recording.t_s}, {"x_m", recording.x_m}};
  if (!recording.y_m.empty()) columns.push_back({"y_m", recording.y_m});
  columns.push_back({"keyphasor_v", recording.keyphasor_v});
  std::string bytes = matlab::version_5_file("MATLAB 5.0 MAT-file, written by rubdata", columns);
  batch::write_whole_file(file, bytes);
  return bytes;
}

}  // namespace rubsweep::dataset
