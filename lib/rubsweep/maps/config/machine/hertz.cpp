#include "rubsweep/maps/config/machine/hertz.hpp"

#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {
namespace {

using Shape = model::HertzShape;
using HalfWidth = model::HertzHalfWidth;

constexpr yaml::Words<Shape, 3> shapes{{"cylinder", "flat", "hole"},
                                       {Shape::cylinder, Shape::flat, Shape::hole}};
constexpr yaml::Words<HalfWidth, 2> half_widths{{"textbook", "paper"},
                                                {HalfWidth::textbook, HalfWidth::paper}};

void read_material(yaml::Section& section, model::HertzBody& body) {
  model::HertzBody::visit_material(body,
                                   [&](std::string_view name, double& field, const model::Range& range) {
                                     section.field(name, field, range);
                                   });
}

void print_material(yaml::Printer& printer, const model::HertzBody& body) {
  model::HertzBody::visit_material(
      body, [&](std::string_view name, double field, const model::Range&) { printer.number(name, field); });
}

void read_rotor(yaml::Section& section, model::HertzBody& rotor) {
  const auto value = section.require("rotor", "a map");
  if (!value) return;
  yaml::Section body(*value);
  body.field("radius_m", rotor.radius_m, model::positive);
  read_material(body, rotor);
  body.refuse_unknown_keys();
}

void read_casing(yaml::Section& section, model::HertzLine& contact) {
  const auto value = section.require("casing", "a map");
  if (!value) return;
  yaml::Section body(*value);
  body.field("shape", contact.casing_shape, shapes);
  if (contact.casing_shape != Shape::flat) body.field("radius_m", contact.casing.radius_m, model::positive);
  read_material(body, contact.casing);
  body.refuse_unknown_keys();
  if (contact.casing_shape == Shape::hole && contact.casing.radius_m <= contact.rotor.radius_m) {
    body.refuse_together("radius_m", {"radius_m"}, "the rotor does not fit into the hole",
                         "a number above the rotor's radius_m");
  }
}

}  // namespace

std::optional<model::HertzLine> read_hertz(const yaml::Value& value) {
  yaml::Section section(value);
  model::HertzLine contact;
  section.field("length_m", contact.length_m, model::positive);
  read_rotor(section, contact.rotor);
  read_casing(section, contact);
  section.field("design_force_n", contact.design_force_n, model::positive);
  section.field("half_width", contact.half_width, half_widths);
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
  printer.number("length_m", contact.length_m);
  printer.open("rotor");
  printer.number("radius_m", contact.rotor.radius_m);
  print_material(printer, contact.rotor);
  printer.close();
  printer.open("casing");
  printer.field("shape", contact.casing_shape, shapes);
  if (contact.casing_shape != Shape::flat) printer.number("radius_m", contact.casing.radius_m);
  print_material(printer, contact.casing);
  printer.close();
  printer.number("design_force_n", contact.design_force_n);
  printer.field("half_width", contact.half_width, half_widths);
  printer.close();
}

}  // namespace rubsweep::config::machine
