#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace rubsweep::config::yaml {

/// The one of `names` that `word` most probably means: the shortest one that only adds a unit to it ("mass"
/// -> "mass_kg"), else the one with the smallest edit distance (insert, delete, replace: 1 each), the first
/// listed of equals. Empty when none is within a third of its own length.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> names);

}  // namespace rubsweep::config::yaml
