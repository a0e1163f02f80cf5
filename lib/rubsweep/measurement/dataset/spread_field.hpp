#pragma once

#include <string_view>

#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/measurement/diagnose/spread.hpp"

namespace rubsweep::config::dataset {

/// Reads a number, which is then known, or a list of two, the bounds of an interval; `logarithmic` is how
/// every part of an interval is equally likely. Leaves `target` as it is where the key is missing.
void read_spread(yaml::Section& section, std::string_view name, const model::Range& range, bool logarithmic,
                 diagnose::Spread& target);

}  // namespace rubsweep::config::dataset
