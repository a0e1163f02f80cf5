#pragma once

#include "rubsweep/measurement/dataset/data_study.hpp"

namespace rubsweep::dataset {

/// A study of a few short recordings.
inline DataStudy small_study() {
  DataStudy study;
  study.recordings = 6;
  study.recordings_per_machine = 2;
  study.measurement.turns = 12;
  study.candidates = {diagnose::usual_candidate(diagnose::Cause::no_rub),
                      diagnose::usual_candidate(diagnose::Cause::one_side)};
  for (diagnose::Candidate& candidate : study.candidates) {
    candidate.clearance_m = {1e-4, 5e-4, true};
    spread_of(candidate, diagnose::Unknown::natural_frequency) = {25, 35, false};
    spread_of(candidate, diagnose::Unknown::damping_ratio) = {0.02, 0.03, true};
  }
  return study;
}

}  // namespace rubsweep::dataset
