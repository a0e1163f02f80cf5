#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "rubsweep/dataset/data_study.hpp"

namespace rubsweep::dataset {

/// Purposes of the random numbers of a set.
enum Purpose : std::uint64_t { of_machine, of_recording, of_readings };

/// Numbers of a machine that its recordings have in common.
struct MachineDraw {
  diagnose::Point unit{};  ///< places in the ranges of its candidate; those of one recording are drawn anew
  double clearance_m = 0, stop_angle_deg = 0, mark_turns = 0;
  std::string_view part{};     ///< training, validation or test
  std::vector<double> gain{};  ///< of each probe
};

/// Candidates take turns.
std::size_t candidate_of(const DataStudy& study, std::size_t machine);

/// Depends on the study and the number of the machine alone.
MachineDraw draw_machine(const DataStudy& study, std::size_t machine);

}  // namespace rubsweep::dataset
