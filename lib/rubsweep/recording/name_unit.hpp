#pragma once

#include <string>
#include <string_view>

namespace rubsweep::recording {

/// Unit that the ending _s or _m of a name says, as in the programs' own tables; empty for other names.
inline std::string unit_in_ending(std::string_view name) {
  return name.ends_with("_s") || name.ends_with("_m") ? std::string(1, name.back()) : std::string();
}

}  // namespace rubsweep::recording
