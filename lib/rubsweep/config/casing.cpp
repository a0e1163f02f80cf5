#include "rubsweep/config/casing.hpp"

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {

namespace {

constexpr std::string_view rigid = "rigid";
constexpr std::string_view forms = "rigid, or a map with mass_kg, stiffness_n_per_m, damping_ratio";

}  // namespace

std::optional<model::Casing> read_casing(const Value& value) {
  if (value.node.kind == Node::Kind::scalar) {
    read_word(value, {&rigid, 1}, forms);
    return std::nullopt;
  }
  Section section(value, forms);
  model::Casing casing;
  read_fields(section, casing);
  section.refuse_unknown_keys();
  return casing;
}

void print_casing(Printer& printer, const std::optional<model::Casing>& casing) {
  if (!casing) {
    printer.word("casing", rigid);
    return;
  }
  printer.open("casing");
  print_fields(printer, *casing);
  printer.close();
}

}  // namespace rubsweep::config
