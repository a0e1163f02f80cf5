#include "rubsweep/integrate/adaptive/start_adaptive.hpp"

#include "rubsweep/integrate/adaptive/stepper_table.hpp"

namespace rubsweep::integrate::adaptive {

run::Cursor start_adaptive(const scene::Scene& scene, const run::SolverOptions& options) {
  return row_of(options.stepper).start(scene, options);
}

}  // namespace rubsweep::integrate::adaptive
