#pragma once

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// Starts a run of `scene` with one of Odeint's steppers; the scene need not outlive the call. The
/// specialised model (stepper, number of coordinates, contact handling) is chosen here, once.
run::Cursor start_adaptive(const scene::Scene& scene, const run::SolverOptions& options);

namespace detail {
run::Cursor start_dopri5(const scene::Scene& scene, const run::SolverOptions& options);
run::Cursor start_cash_karp54(const scene::Scene& scene, const run::SolverOptions& options);
run::Cursor start_rkf78(const scene::Scene& scene, const run::SolverOptions& options);
run::Cursor start_bulirsch_stoer(const scene::Scene& scene, const run::SolverOptions& options);
run::Cursor start_rosenbrock4(const scene::Scene& scene, const run::SolverOptions& options);
}  // namespace detail

}  // namespace rubsweep::integrate::adaptive
