#include "rubsweep/config/machine/casing.hpp"

#include "rubsweep/config/yaml/section.hpp"

namespace rubsweep::config::machine {

namespace {

constexpr std::string_view rigid = "rigid";
constexpr std::string_view casing_forms = "rigid, or a map with mass_kg, stiffness_n_per_m, damping_ratio";

}  // namespace

std::optional<model::Casing> read_casing(const yaml::Value& value) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    read_word(value, {&rigid, 1}, casing_forms);
    return std::nullopt;
  }
  yaml::Section section(value, casing_forms);
  model::Casing casing;
  read_fields(section, casing);
  section.refuse_unknown_keys();
  return casing;
}

void print_casing(yaml::Printer& printer, const std::optional<model::Casing>& casing) {
  if (!casing) {
    printer.word("casing", rigid);
    return;
  }
  printer.open("casing");
  print_fields(printer, *casing);
  printer.close();
}

}  // namespace rubsweep::config::machine
