#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config {

/// Refuses numbers that are certainly in a wrong unit: a clearance as large as the radius (millimetres), a
/// kick that lasts a hundred periods of the rotor (milliseconds), a speed a hundred times the rotor's natural
/// frequency (revolutions per minute), a shaft as soft as air (gigapascals). The library itself would
/// simulate all of these. `root` is a whole configuration whose values have been read without a problem, and
/// `machine` is its machine (null for a configuration without a rotor). Keys that `root` does not have are
/// not judged.
void refuse_unit_slips(const yaml::Value& root, const model::Machine* machine);

/// Questions about an accepted configuration: `file:line:column: key: ... (millimetres?)`. In a list of
/// numbers, or among equal questions, only the first one is asked.
std::vector<std::string> unit_questions(const yaml::Value& root, const model::Machine* machine);

}  // namespace rubsweep::config
