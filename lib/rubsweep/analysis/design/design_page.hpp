#pragma once

#include <string>

#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/core/model/length_text.hpp"

namespace rubsweep::design {

/// A design check as one page for a terminal: what is asked, what comes out, `ok` or `NOT MET` where there is
/// a limit. Lengths as asked for, in um otherwise; vibration is peak to peak in any case.
std::string design_page(const DesignCheck& check, const model::ShownLengths& shown = {});

}  // namespace rubsweep::design
