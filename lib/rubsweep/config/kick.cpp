#include "rubsweep/config/kick.hpp"

#include "rubsweep/config/section.hpp"

namespace rubsweep::config {

model::Kick read_kick(const Value& value) {
  Section section(value);
  model::Kick kick;
  read_fields(section, kick);
  section.field("angle_deg", kick.angle_deg, model::any_finite);
  section.refuse_unknown_keys();
  return kick;
}

void print_kick(Printer& printer, const model::Kick& kick) {
  printer.open("kick");
  print_fields(printer, kick);
  printer.field("angle_deg", kick.angle_deg, model::any_finite);
  printer.close();
}

}  // namespace rubsweep::config
