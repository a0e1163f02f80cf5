#pragma once

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// True when the equations of motion do not depend on time in the frame that turns with the shaft; the pulse
/// and the initial state are left aside. Every contact is then a centred annular stop (offset exactly zero),
/// nothing pulls or strikes in a constant direction, the forcing turns forward, and structure and points are
/// isotropic in pairs of coordinates (x, y): every 2 x 2 block has the form [[a, -b], [b, a]].
bool rotationally_symmetric(const scene::Scene& scene);

}  // namespace rubsweep::response::rotating
