#pragma once

#include "rubsweep/integrate/exact.hpp"
#include "rubsweep/response/full_spectrum.hpp"

namespace rubsweep::response {

/// What one thread keeps from run to run. Changes no result, only what has to be made again.
struct Workspace {
  SpectrumWorkspace spectrum;
  integrate::ExactPlans plans;
};

}  // namespace rubsweep::response
