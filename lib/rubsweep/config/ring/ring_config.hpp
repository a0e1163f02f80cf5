#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rubsweep/batch/captions.hpp"
#include "rubsweep/ring/study.hpp"

namespace rubsweep::config::ring {

/// One complete configuration of `ringstab`: the study and where its files go.
struct RingConfig {
  rubsweep::ring::Study study;
  std::filesystem::path output_directory;
  batch::Captions captions{};
  std::vector<std::string> questions{};  ///< questions about likely slips of units (see unit_slips.hpp)
};

}  // namespace rubsweep::config::ring
