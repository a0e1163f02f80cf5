#pragma once

#include <string>

#include "fuzz/byte_source.hpp"

namespace rubsweep::fuzz {

/// A configuration of one cell made of whole sections, so that most of its numbers decide something: Jeffcott
/// rotors and rotor kits, every kind of stop, friction, damping and casing, kicks and none, every solver. Its
/// runs are short.
std::string random_config(ByteSource& bytes);

}  // namespace rubsweep::fuzz
