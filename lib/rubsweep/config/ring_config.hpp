#pragma once

#include <filesystem>

#include "rubsweep/ring/study.hpp"

namespace rubsweep::config {

/// One complete configuration of `ringstab`: the study and where its files go.
struct RingConfig {
  ring::Study study;
  std::filesystem::path output_directory;
};

}  // namespace rubsweep::config
