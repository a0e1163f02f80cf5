#pragma once

#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// Gives a study that was read from `root` without a problem its with_keys, if it varies keys at all: each
/// call writes the numbers over the printed study, as `--set` would over the printed configuration, and reads
/// the result. Every value of every axis is tried by itself; the first of an axis that is not allowed, a key
/// that does not exist and one that holds no number are problems of the place where the keys are named.
void vary_keys(const yaml::Value& root, sweep::Study& study);

}  // namespace rubsweep::config
