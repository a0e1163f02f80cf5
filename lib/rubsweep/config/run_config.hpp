#pragma once

#include <filesystem>

#include "rubsweep/sweep/study.hpp"

namespace rubsweep::config {

/// One complete configuration of `rubsweep`: the study and where its files go.
struct RunConfig {
  sweep::Study study;
  std::filesystem::path output_directory;
};

}  // namespace rubsweep::config
