#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace rubsweep::batch {

/// The whole content of a file; throws where it cannot be read.
inline std::string read_whole_file(const std::filesystem::path& path) {
  std::ifstream file;
  file.exceptions(std::ios::failbit | std::ios::badbit);
  file.open(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace rubsweep::batch
