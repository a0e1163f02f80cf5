#pragma once

#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/section.hpp"
#include "rubsweep/model/shaft_segment.hpp"

namespace rubsweep::config::machine {

/// Keys of a segment of `rotor.shaft` beside its numbers: shear_coefficient (cowper, hutchinson or none),
/// rotary_inertia and gyroscopic (on or off), and `layers`, a list of sections of the same length.
void read_segment(yaml::Section& section, model::ShaftSegment& segment);
void print_segment(yaml::Printer& printer, const model::ShaftSegment& segment);

}  // namespace rubsweep::config::machine
