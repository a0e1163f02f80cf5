#include "rubsweep/config/machine/rotor.hpp"

#include <array>
#include <string_view>

#include "rubsweep/config/machine/jeffcott.hpp"
#include "rubsweep/config/machine/matrix_rotor.hpp"
#include "rubsweep/config/machine/ross_file.hpp"
#include "rubsweep/config/machine/rotor_kit.hpp"
#include "rubsweep/config/yaml/section.hpp"
#include "rubsweep/overloaded.hpp"

namespace rubsweep::config::machine {
namespace {

/// In the order of model::Rotor, then those of other tools' files, which become one of these.
constexpr std::array<std::string_view, 4> rotor_kinds{"jeffcott", "rotor_kit", "ross", "matrices"};

}  // namespace

void read_rotor(const yaml::Value& value, model::Machine& machine) {
  yaml::Section section(value);
  const auto kind = section.require_kind("kind", rotor_kinds);
  if (kind && rotor_kinds[*kind] == "rotor_kit") {
    machine.rotor = read_rotor_kit(section);
  } else if (kind && rotor_kinds[*kind] == "ross") {
    machine.rotor = read_ross_rotor(section);
  } else if (kind && rotor_kinds[*kind] == "matrices") {
    machine.rotor = read_matrix_rotor(section);
  } else {
    machine.rotor = read_jeffcott(section);
  }
  section.refuse_unknown_keys();
}

void print_rotor(yaml::Printer& printer, const model::Machine& machine, MatrixPrint matrices) {
  const model::RotorKit* by_matrices = model::kit_of(machine);
  printer.open("rotor");
  printer.word("kind", by_matrices != nullptr && by_matrices->matrices ? "matrices"
                                                                       : rotor_kinds[machine.rotor.index()]);
  std::visit(overloaded{[&](const model::JeffcottRotor& rotor) { print_fields(printer, rotor); },
                        [&](const model::RotorKit& kit) { print_rotor_kit(printer, kit, matrices); }},
             machine.rotor);
  printer.close();
}

}  // namespace rubsweep::config::machine
