#include "rubsweep/maps/config/machine/hertz.hpp"

#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

std::optional<model::HertzLine> read_hertz(const yaml::Value& value) {
  yaml::Section section(value);
  model::HertzLine contact;
  model::HertzLine::visit_keys(contact, section);
  if (contact.casing_shape == model::HertzShape::hole && contact.casing.radius_m <= contact.rotor.radius_m) {
    yaml::refuse(
        {*find_node(value.node, "casing.radius_m"), value.path + ".casing.radius_m", value.diagnostics},
        "the rotor does not fit into the hole", "a number above the rotor's radius_m");
  }
  section.refuse_unknown_keys();
  if (!section.is_sound()) return std::nullopt;
  if (contact.length_m < 2 * contact::hertz_half_width_m(contact, contact.design_force_n)) {
    section.refuse_together("design_force_n", {"design_force_n"}, "the contact is wider than long",
                            "a smaller force or a greater length_m");
    return std::nullopt;
  }
  return contact;
}

void print_hertz(yaml::Printer& printer, const model::HertzLine& contact) {
  printer.open("hertz");
  model::HertzLine::visit_keys(contact, printer);
  printer.close();
}

}  // namespace rubsweep::config::machine
