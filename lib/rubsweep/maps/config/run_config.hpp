#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rubsweep/maps/batch/captions.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// One complete configuration of `rubsweep`: the study and where its files go.
struct RunConfig {
  sweep::Study study;
  std::filesystem::path output_directory;
  double warn_over_clearances = 10;  ///< cells whose rotor moves farther are counted and warned of
  batch::Captions captions{};
  std::vector<std::string> questions{};  ///< questions about likely slips of units (see unit_slips.hpp)
};

}  // namespace rubsweep::config
