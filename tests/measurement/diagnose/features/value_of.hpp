#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "rubsweep/measurement/diagnose/features/line_features.hpp"

namespace rubsweep::diagnose::features {

/// Value of the feature with this name, which must exist.
inline double value_of(const Features& features, std::string_view name) {
  for (const Feature& feature : features)
    if (feature.name == name) return feature.value;
  ADD_FAILURE() << name;
  return 0;
}

}  // namespace rubsweep::diagnose::features
