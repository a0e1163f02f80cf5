#pragma once

#include "rubsweep/integrate/exact/mode_cache.hpp"
#include "rubsweep/numerics/modal_form_cache.hpp"
#include "rubsweep/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::motion {

/// What one thread keeps from run to run. Changes no result, only what has to be made again.
struct Workspace {
  spectrum::SpectrumWorkspace spectrum;
  integrate::exact::ModeCache modes;
  numerics::ModalFormCache forms;  ///< of rotors in flight
};

}  // namespace rubsweep::response::motion
