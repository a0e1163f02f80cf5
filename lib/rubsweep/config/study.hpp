#pragma once

#include "rubsweep/config/section.hpp"
#include "rubsweep/sweep/study.hpp"

namespace rubsweep::config {

/// Everything of a configuration but `output`, from the sections of its root. Study::with_keys is left empty.
sweep::Study read_study(Section& root);

}  // namespace rubsweep::config
