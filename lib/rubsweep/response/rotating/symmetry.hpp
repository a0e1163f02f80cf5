#pragma once

#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// True when the scene, its pulse and its initial state left aside, looks the same from every direction once
/// one turns with the shaft: there it does not depend on time. Every contact is a centred annular stop
/// (offset exactly zero), nothing pulls or strikes in a constant direction, the forcing turns forward, and
/// structure and points are isotropic in pairs of coordinates (x, y): every 2 x 2 block has the form [[a,
/// -b], [b, a]].
bool rotationally_symmetric(const scene::Scene& scene);

}  // namespace rubsweep::response::rotating
