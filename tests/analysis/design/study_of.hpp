#pragma once

#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::design {

inline sweep::Study study_of(const model::Machine& machine) {
  sweep::Study study;
  study.machine = machine;
  return study;
}

}  // namespace rubsweep::design
