#pragma once

#include "rubsweep/integrate/options.hpp"
#include "rubsweep/integrate/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate {

/// Starts a run of `scene` with one of Odeint's steppers; the scene need not outlive the call. The
/// specialised model (stepper, number of coordinates, contact handling) is chosen here, once.
Cursor start_adaptive(const scene::Scene& scene, const SolverOptions& options);

namespace detail {
Cursor start_dopri5(const scene::Scene& scene, const SolverOptions& options);
Cursor start_cash_karp54(const scene::Scene& scene, const SolverOptions& options);
Cursor start_rkf78(const scene::Scene& scene, const SolverOptions& options);
Cursor start_bulirsch_stoer(const scene::Scene& scene, const SolverOptions& options);
Cursor start_rosenbrock4(const scene::Scene& scene, const SolverOptions& options);
}  // namespace detail

}  // namespace rubsweep::integrate
