#include "rubsweep/config/rotor.hpp"

#include <array>
#include <string_view>

#include "rubsweep/config/rotor_kit.hpp"
#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::array<std::string_view, 2> kinds{"jeffcott", "rotor_kit"};

}  // namespace

void read_rotor(const Value& value, model::Machine& machine) {
  Section section(value);
  const auto kind = section.require_kind("kind", kinds);
  if (kind && kinds[*kind] == "rotor_kit") {
    machine.kit = read_rotor_kit(section);
  } else {
    read_fields(section, machine.rotor);
  }
  section.refuse_unknown_keys();
}

void print_rotor(Printer& printer, const model::Machine& machine) {
  printer.open("rotor");
  printer.word("kind", machine.kit ? "rotor_kit" : "jeffcott");
  if (machine.kit) {
    print_rotor_kit(printer, *machine.kit);
  } else {
    print_fields(printer, machine.rotor);
  }
  printer.close();
}

}  // namespace rubsweep::config
