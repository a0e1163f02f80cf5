#pragma once

#include <string>

#include "rubsweep/design/design_check.hpp"

namespace rubsweep::design {

/// A design check as one page for a terminal: what is asked, what comes out, `ok` or `NOT MET` where there is
/// a limit.
std::string design_page(const DesignCheck& check);

}  // namespace rubsweep::design
