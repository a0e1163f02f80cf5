#include "rubsweep/recording/recording_file.hpp"

#include "rubsweep/recording/delimited_text.hpp"
#include "rubsweep/recording/matlab_file.hpp"
#include "rubsweep/recording/sound_file.hpp"

namespace rubsweep::recording {

Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes) {
  const bool sound = bytes.starts_with("RIFF") || bytes.starts_with("RIFX") || bytes.starts_with("RF64");
  if (sound) return read_sound_file(file);
  // Version 4 has no words at its begin, only its ending tells it.
  if (bytes.starts_with("MATLAB ") || bytes.starts_with("\x89HDF") || file.extension() == ".mat")
    return read_matlab_file(file);
  return read_delimited_text(bytes, file.string());
}

}  // namespace rubsweep::recording
