#pragma once

#include <string>
#include <vector>

#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config {

/// Questions about a study whose numbers are plausible each by itself and odd together, as unit_questions
/// asks: all speeds far below the natural frequency of a Jeffcott rotor, a kick that no cell takes because
/// each begins in contact, a rotor that sags onto a stop, a nominal restitution that no impact delivers.
/// `root` is the configuration that `study` was read from without a problem.
std::vector<std::string> plan_questions(const yaml::Value& root, const sweep::Study& study);

}  // namespace rubsweep::config
