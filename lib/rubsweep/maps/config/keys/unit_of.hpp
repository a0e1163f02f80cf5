#pragma once

#include <string_view>

namespace rubsweep::config::keys {

/// Unit that the end of a key says, as people write it: "N/m" of stiffness_n_per_m; empty without one.
std::string_view unit_of(std::string_view key);

}  // namespace rubsweep::config::keys
