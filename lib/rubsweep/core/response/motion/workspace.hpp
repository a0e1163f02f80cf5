#pragma once

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/numerics/modal_form_cache.hpp"
#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::motion {

/// Caches that one thread keeps from run to run. They save work and change no result.
struct Workspace {
  spectrum::SpectrumWorkspace spectrum;
  integrate::exact::modes::ModeCache modes;
  numerics::ModalFormCache forms;  ///< modal forms of rotors without contact
};

}  // namespace rubsweep::response::motion
