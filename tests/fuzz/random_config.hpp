#pragma once

#include <string>

#include "fuzz/byte_source.hpp"

namespace rubsweep::fuzz {

/// A configuration of one cell, composed of whole sections so that most of its numbers have an effect:
/// Jeffcott rotors and rotor kits, all kinds of stop, friction, damping and casing, with and without kick,
/// all solvers. Its runs are short.
std::string random_config(ByteSource& bytes);

}  // namespace rubsweep::fuzz
