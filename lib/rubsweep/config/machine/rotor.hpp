#pragma once

#include "rubsweep/config/machine/printed_matrices.hpp"
#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/model/machine.hpp"

namespace rubsweep::config::machine {

/// `rotor`: {kind: jeffcott, ...}, see jeffcott.hpp, or {kind:
/// rotor_kit, ...}, see rotor_kit.hpp, or {kind: ross, ...}, see ross_file.hpp, or {kind: matrices, ...}, see
/// matrix_rotor.hpp. Fills machine.rotor.
void read_rotor(const yaml::Value& value, model::Machine& machine);
void print_rotor(yaml::Printer& printer, const model::Machine& machine, MatrixPrint matrices = MatrixPrint::inside);

}  // namespace rubsweep::config::machine
