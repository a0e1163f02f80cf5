#pragma once

#include <filesystem>
#include <string>

#include "rubsweep/maps/batch/input_file.hpp"

namespace rubsweep::config::yaml {

/// Contents of a file, or the reason why there are none.
struct FileBytes {
  std::string text;
  std::string problem;  ///< empty: none
};

/// The bytes of a configuration file, at most one more than a document may have.
FileBytes read_bytes(const std::filesystem::path& file,
                     batch::InputKind kind = batch::InputKind::regular_file);

/// The same of a file that the command line names, which may be one that the caller opened and passed on, as
/// <(...) of a shell is. Throws IoError when the file cannot be read.
std::string read_config_bytes(const std::filesystem::path& file);

}  // namespace rubsweep::config::yaml
