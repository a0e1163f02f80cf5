#pragma once

#include <string>

#include "rubsweep/core/model/stop.hpp"

namespace rubsweep::report {

/// The law of a stop that is not linear, and what a free impact there really returns, for `--explain`.
std::string explain_law(const model::Stop& stop);

}  // namespace rubsweep::report
