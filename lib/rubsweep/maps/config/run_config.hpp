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

  /// Keys of `output` beside the directory.
  static void visit_fields(auto& self, auto&& visit) {
    visit("warn_over_clearances", self.warn_over_clearances,
          model::newer_key(model::positive,
                           "motions beyond so many clearances of the first stop are counted and warned of"));
  }
};

}  // namespace rubsweep::config
