#pragma once

#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// Sets with_keys of a study that was read from `root` without a problem and varies keys. Each call of
/// with_keys writes numbers over the printed study, as `--set` would, and reads the result. This function
/// tries every value of every axis alone. Problems are reported where the keys are named: the first forbidden
/// value of an axis, a key that does not exist, a key that holds no number.
void vary_keys(const yaml::Value& root, sweep::Study& study);

}  // namespace rubsweep::config
