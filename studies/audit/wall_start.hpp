#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::audit {

/// A scene whose rotor begins exactly at a wall, or within one ulp of it, without radial speed.
struct WallStart {
  scene::Scene scene;
  std::string description;  ///< description of stops, velocities and force
};

/// Start number `index` for a seed: random machines with each kind of stops in turn. The rotor is at rest, or
/// moves with its casing or along the wall, with or without slip. A constant force presses it onto the wall,
/// pulls it away, or cancels the radial acceleration, so that a higher derivative decides.
WallStart random_wall_start(std::uint64_t seed, std::size_t index);

/// Solvers that are tested with each start.
inline constexpr std::array<std::string_view, 3> wall_start_solvers{"exact", "series", "adaptive"};

/// Comparison of the first turn with fixed steps that locate no events.
struct WallStartAudit {
  /// Distance of each solver's section from the finest fixed steps, in clearances; infinite where it failed.
  std::array<double, wall_start_solvers.size()> errors{};
  double spread = 0;     ///< distance between fixed steps of different size
  bool decides = false;  ///< whether the fixed steps agree on one section
  bool wrong = false;    ///< whether an error exceeds four times the spread
};

WallStartAudit audit_wall_start(const WallStart& start);

}  // namespace rubsweep::audit
