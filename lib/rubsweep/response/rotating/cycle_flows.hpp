#pragma once

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/response/rotating/limit_cycle.hpp"
#include "rubsweep/response/rotating/rotating_flow.hpp"
#include "rubsweep/response/rotating/rotating_frame.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::response::rotating {

/// A scene's flows as RotatingMotion names them.
struct CycleFlows {
  RotatingFlow exactly, roughly, at_first;

  /// `samples_per_revolution`: of the exact one; the others take none.
  CycleFlows(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
             int samples_per_revolution);

  /// With the rates of `field`; both are referred to.
  RotatingMotion motion(const RotatingField& field) const;
};

}  // namespace rubsweep::response::rotating
