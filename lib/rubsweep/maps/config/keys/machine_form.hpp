#pragma once

#include "rubsweep/maps/config/keys/form.hpp"

/// Sections of a rub configuration that describe the machine.
namespace rubsweep::config::keys {

Form rotor_form();
Form stops_form();
Form kick_form();
Form start_form();

/// Keys of `rotor` beside kind: rotor_kit.
std::vector<Key> rotor_kit_keys();

/// Keys of `rotor` beside kind: ross.
std::vector<Key> ross_keys();

/// Keys of `rotor` beside kind: matrices.
std::vector<Key> matrix_keys();

/// `hertz` of a stop.
Form hertz_form();

/// `friction` of a stop.
Form friction_form();

}  // namespace rubsweep::config::keys
