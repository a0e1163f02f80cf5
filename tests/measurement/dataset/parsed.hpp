#pragma once

#include <string>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::dataset {

/// Parses a text, called study.yaml in messages, and passes its root to `read`; returns the problems, or
/// "none".
template <class Read>
std::string problems(const std::string& text, Read read) {
  try {
    yaml::Diagnostics diagnostics("study.yaml", {});
    const yaml::Node root = parse_config(text, "study.yaml", "a map", {}, diagnostics);
    read(yaml::Value{root, "", diagnostics});
    diagnostics.throw_if_any();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

}  // namespace rubsweep::config::dataset
