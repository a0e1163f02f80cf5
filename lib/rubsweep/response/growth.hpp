#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/response/proof/section_map.hpp"

namespace rubsweep::response {

/// One turn of a motion and of a small disturbance of it: moves the section and returns ln of the factor that
/// the disturbance grew by. Empty: the turn could not be made.
using Growth = std::function<std::optional<double>(std::span<double> section)>;

/// The disturbance is a companion of the motion that starts at `section`, followed through any map.
Growth companion_growth(proof::SectionMap map, std::span<const double> section);

/// The disturbance is a tangent vector, moved by the exact derivative of the section where the turn has
/// closed forms: nothing is lost to the distance of a companion, and there is no second run. Turns without
/// closed forms take the difference to a companion. `map` must outlive what is returned.
Growth tangent_growth(proof::SceneMap& map);

}  // namespace rubsweep::response
