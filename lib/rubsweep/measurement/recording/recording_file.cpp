#include "rubsweep/measurement/recording/recording_file.hpp"

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/measurement/recording/delimited_text.hpp"
#include "rubsweep/measurement/recording/matlab_file.hpp"
#include "rubsweep/measurement/recording/sound_file.hpp"

namespace rubsweep::recording {

Channels read_recording_file(const std::filesystem::path& file, std::string_view bytes) {
  const bool sound = bytes.starts_with("RIFF") || bytes.starts_with("RIFX") || bytes.starts_with("RF64");
  if (sound) return read_sound_file(file);
  // MATLAB's own HDF5 begins with its words, and not with the mark of HDF5.
  if (bytes.starts_with("\x89HDF"))
    throw ConfigError(file.string() +
                      ": is HDF5 without MATLAB's head, allowed: a MATLAB file of version 4, 5 or 7.3, which "
                      "Octave writes with save -v7");
  if (bytes.starts_with("TDSm"))
    throw ConfigError(file.string() +
                      ": is a file of LabVIEW's TDMS, allowed: its signals as a table of text, "
                      "which LabVIEW, DIAdem and nptdms export");
  // Version 4 has no words at its begin, only its ending tells it.
  if (bytes.starts_with("MATLAB ") || file.extension() == ".mat")
    return read_matlab_file(bytes, file.string());
  batch::check_table_text(bytes, file);  // a table that a program of ours wrote may be a recording, too
  return read_delimited_text(bytes, file.string());
}

}  // namespace rubsweep::recording
