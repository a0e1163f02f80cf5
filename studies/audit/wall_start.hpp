#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::audit {

/// A scene whose rotor begins on a wall, or within an ulp of it, without a radial speed against it.
struct WallStart {
  scene::Scene scene;
  std::string description;  ///< of the stops, the velocities and the force
};

/// Start number `index` of a seed: random machines of every kind of stops, in turn. The rotor is at rest, or
/// moves with its casing or along the wall, with or without slip. A constant force presses it on the wall,
/// pulls it off, or leaves no radial acceleration, so that a later derivative decides.
WallStart random_wall_start(std::uint64_t seed, std::size_t index);

/// Solvers that a start is given to.
inline constexpr std::array<std::string_view, 3> wall_start_solvers{"exact", "series", "adaptive"};

/// The first turn of a start, against one by fixed steps that locates no event.
struct WallStartAudit {
  /// Section of each solver from that of the finest fixed steps, in clearances; infinite where one fails.
  std::array<double, wall_start_solvers.size()> errors{};
  double spread = 0;     ///< of the fixed steps themselves
  bool decides = false;  ///< these come to one section
  bool wrong = false;    ///< some error is beyond four times the spread
};

WallStartAudit audit_wall_start(const WallStart& start);

}  // namespace rubsweep::audit
