#include "rubsweep/config/rotor.hpp"

#include <array>
#include <string_view>

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {
namespace {

constexpr std::array<std::string_view, 1> kinds{"jeffcott"};

}  // namespace

model::JeffcottRotor read_rotor(const Value& value) {
  Section section(value);
  model::JeffcottRotor rotor;
  section.require_kind("kind", kinds);
  read_fields(section, rotor);
  section.refuse_unknown_keys();
  return rotor;
}

void print_rotor(Printer& printer, const model::JeffcottRotor& rotor) {
  printer.open("rotor");
  printer.word("kind", "jeffcott");
  print_fields(printer, rotor);
  printer.close();
}

}  // namespace rubsweep::config
