#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config {

/// Refuses what is certainly a slip: a clearance as large as the radius (millimetres), a kick that lasts a
/// hundred periods of the rotor (milliseconds), a speed a hundred times its natural frequency (revolutions
/// per minute), a shaft as soft as air (gigapascals). The library itself simulates all of these. `root` is a
/// whole configuration whose values have been read without a problem, as `machine` if it is one of a rotor;
/// what it does not hold is not judged.
void refuse_unit_slips(const yaml::Value& root, const model::Machine* machine);

/// Questions about a configuration that is accepted: `file:line:column: key: ... (millimetres?)`, only the
/// first number of a list or of equal questions.
std::vector<std::string> unit_questions(const yaml::Value& root, const model::Machine* machine);

}  // namespace rubsweep::config
