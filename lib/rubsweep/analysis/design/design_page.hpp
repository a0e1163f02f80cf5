#pragma once

#include <string>

#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/core/model/length_text.hpp"

namespace rubsweep::design {

/// A design check as one page for a terminal: input, results, and `ok` or `NOT MET` where there is a limit.
/// Lengths are in the requested unit, in um by default; vibration is always peak to peak.
std::string design_page(const DesignCheck& check, const model::ShownLengths& shown = {});

}  // namespace rubsweep::design
